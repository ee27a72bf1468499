//! What generated text consists of, and where it compiles.

use std::{fs, path::Path, process::Command};

use kane_codegen::{
    config::{Formulation, Functions},
    description::{Base, Reading, no_includes},
    diagnostic::Source,
    functions::CATALOGUE,
    generate::generate,
    options::Options,
};
use kane_test_systems::{BAKED_RUNTIME_CHANGED, RANDOM};
use syn::visit::{self, Visit};

/// The module of a description, with every function.
fn module(name: &str, text: &str, formulation: Formulation) -> String {
    let options = Options {
        functions: Functions::All(Vec::new()),
        formulation,
        ..Options::default()
    };
    generate(&Source::new(name, text), name, &options, &no_includes)
        .expect("a right description")
        .source
}

/// The bundled systems, the smaller random ones, and one with parameters in the notes' formulation.
fn modules() -> Vec<(String, String)> {
    let bundled = [
        ("cart_pole", include_str!("../../../models/cart_pole.toml")),
        (
            "eight_body",
            include_str!("../../../models/eight_body.toml"),
        ),
    ];
    let random = RANDOM[..5].iter();
    let random = random.map(|compiled| (compiled.name, compiled.model));
    let mut modules: Vec<_> = bundled
        .into_iter()
        .chain(random)
        .map(|(name, model)| (name.to_owned(), module(name, model, Formulation::Cheapest)))
        .collect();
    let notes = module(
        "runtime",
        BAKED_RUNTIME_CHANGED[1].model,
        Formulation::Notes,
    );
    modules.push(("runtime in the notes' formulation".to_owned(), notes));
    modules
}

/// Collects what has no place in a generated function.
#[derive(Default)]
struct Found {
    what: Vec<String>,
    /// What counts the columns, in a helper.
    lane: Option<&'static str>,
}

impl Found {
    fn add(&mut self, what: impl Into<String>) {
        self.what.push(what.into());
    }

    /// What stages before keep is lent to a stage, and what a helper reads to that; what is filled for helpers to both.
    fn visit_lent(&mut self, argument: &syn::Expr) {
        match argument {
            syn::Expr::Reference(lent) => match (&lent.mutability, &*lent.expr) {
                (Some(_), syn::Expr::Path(own)) if own.path.get_ident().is_some_and(is_scratch) => {
                }
                (Some(_), _) => self.add("something that is lent to be changed"),
                (None, own) => self.visit_expr(own),
            },
            own => self.visit_expr(own),
        }
    }
}

/// True for an array that a function fills for its helpers, or that a helper fills.
fn is_scratch(name: &syn::Ident) -> bool {
    let name = name.to_string();
    let mut kinds = ["shared", "sides", "solved"].into_iter();
    kinds.any(|kind| name.starts_with(kind))
}

/// `R::name` is a path of two segments.
fn called(function: &syn::Expr) -> Option<String> {
    let syn::Expr::Path(path) = function else {
        return None;
    };
    let segments = path
        .path
        .segments
        .iter()
        .map(|segment| segment.ident.to_string());
    Some(segments.collect::<Vec<_>>().join("::"))
}

impl<'ast> Visit<'ast> for Found {
    fn visit_expr(&mut self, expr: &'ast syn::Expr) {
        match expr {
            syn::Expr::Binary(binary) => match binary.op {
                syn::BinOp::Add(_)
                | syn::BinOp::Sub(_)
                | syn::BinOp::Mul(_)
                | syn::BinOp::Div(_) => {}
                _ => self.add("an operator other than + - * /"),
            },
            syn::Expr::Unary(unary)
                if matches!(unary.op, syn::UnOp::Neg(_) | syn::UnOp::Deref(_)) => {}
            syn::Expr::Assign(_)
            | syn::Expr::Array(_)
            | syn::Expr::Field(_)
            | syn::Expr::Lit(_)
            | syn::Expr::Paren(_)
            | syn::Expr::Path(_)
            | syn::Expr::Repeat(_)
            | syn::Expr::Struct(_) => {}
            syn::Expr::Call(call) => match called(&call.func).as_deref() {
                Some("R::from_f64" | "R::sin_cos" | "R::sin_cos_array" | "R::abs") => {}
                Some("kane::store") => {
                    match &call.args[0] {
                        syn::Expr::Reference(place) => self.visit_expr(&place.expr),
                        _ => self.add("a store to what is not named"),
                    }
                    self.visit_expr(&call.args[1]);
                    return;
                }
                Some(part) if part.starts_with("self::") && is_part(part) => {
                    for argument in &call.args {
                        self.visit_lent(argument);
                    }
                    return;
                }
                other => self.add(format!("a call of {other:?}")),
            },
            syn::Expr::Index(index) => {
                let is_integer = matches!(&*index.index, syn::Expr::Lit(literal) if matches!(literal.lit, syn::Lit::Int(_)));
                let is_lane = matches!(&*index.index, syn::Expr::Path(own) if own.path.get_ident().is_some_and(|own| self.lane.is_some_and(|lane| own == lane)));
                if is_lane {
                    // The name of the lane is no index elsewhere.
                    self.visit_expr(&index.expr);
                    return;
                }
                if !is_integer {
                    self.add("an index that is no integer literal");
                }
            }
            other => self.add(format!(
                "an expression of another kind: {:?}",
                std::mem::discriminant(other)
            )),
        }
        visit::visit_expr(self, expr);
    }

    /// A `let` may leave its values to assignments below; without `mut`, rustc sees to it that each is assigned once.
    fn visit_local(&mut self, local: &'ast syn::Local) {
        if local
            .init
            .as_ref()
            .is_some_and(|init| init.diverge.is_some())
        {
            self.add("a `let` with `else`");
        }
        visit::visit_local(self, local);
    }

    fn visit_pat_ident(&mut self, pattern: &'ast syn::PatIdent) {
        let is_scratch = is_scratch(&pattern.ident);
        if pattern.mutability.is_some() && !is_scratch
            || pattern.by_ref.is_some()
            || pattern.subpat.is_some()
        {
            self.add("a name that is not bound once");
        }
    }

    fn visit_macro(&mut self, _: &'ast syn::Macro) {
        self.add("a macro");
    }

    fn visit_item(&mut self, _: &'ast syn::Item) {
        self.add("an item");
    }
}

/// In a whole module: what may stand nowhere.
#[derive(Default)]
struct Anywhere(Vec<&'static str>);

impl<'ast> Visit<'ast> for Anywhere {
    fn visit_expr(&mut self, expr: &'ast syn::Expr) {
        let found = match expr {
            syn::Expr::Unsafe(_) => Some("unsafe"),
            syn::Expr::ForLoop(own) if columns(own).is_some() => None,
            syn::Expr::ForLoop(_) | syn::Expr::While(_) | syn::Expr::Loop(_) => Some("a loop"),
            syn::Expr::If(_) | syn::Expr::Match(_) => Some("a branch"),
            syn::Expr::Closure(_) => Some("a closure"),
            syn::Expr::Macro(_) => Some("a macro"),
            _ => None,
        };
        self.0.extend(found);
        visit::visit_expr(self, expr);
    }

    fn visit_attribute(&mut self, attribute: &'ast syn::Attribute) {
        if matches!(attribute.style, syn::AttrStyle::Inner(_)) {
            self.0.push("an inner attribute");
        }
    }

    fn visit_signature(&mut self, signature: &'ast syn::Signature) {
        if signature.unsafety.is_some() || signature.asyncness.is_some() || signature.abi.is_some()
        {
            self.0.push("a function of another kind");
        }
    }

    fn visit_item_use(&mut self, _: &'ast syn::ItemUse) {
        self.0.push("a use");
    }
}

/// True for a stage of a function, and for a helper.
fn is_part(name: &str) -> bool {
    name.contains("_stage_") || is_helper(name)
}

fn is_helper(name: &str) -> bool {
    name.contains("_lockstep_")
}

/// What a loop over columns repeats: it goes through the first row of `sides`, an array of known length.
fn columns(own: &syn::ExprForLoop) -> Option<&syn::Block> {
    let syn::Pat::Tuple(pattern) = &*own.pat else {
        return None;
    };
    let mut parts = pattern.elems.iter();
    let is_lane = matches!(
        [parts.next(), parts.next(), parts.next()],
        [Some(syn::Pat::Ident(lane)), Some(syn::Pat::Wild(_)), None] if lane.ident == "lane"
    );
    let row = method(&own.expr, "enumerate").and_then(|own| method(own, "iter"));
    let is_row = matches!(
        row,
        Some(syn::Expr::Index(row)) if is_path(&row.expr, "sides") && number(&row.index) == Some(0)
    );
    (is_lane && is_row && own.label.is_none()).then_some(&own.body)
}

/// What a method of this name is called of, without arguments.
fn method<'a>(expr: &'a syn::Expr, name: &str) -> Option<&'a syn::Expr> {
    match expr {
        syn::Expr::MethodCall(call) if call.method == name && call.args.is_empty() => {
            Some(&call.receiver)
        }
        _ => None,
    }
}

fn is_path(expr: &syn::Expr, name: &str) -> bool {
    matches!(expr, syn::Expr::Path(own) if own.path.is_ident(name))
}

fn number(expr: &syn::Expr) -> Option<usize> {
    match expr {
        syn::Expr::Lit(literal) => match &literal.lit {
            syn::Lit::Int(number) => number.base10_parse().ok(),
            _ => None,
        },
        _ => None,
    }
}

/// How many columns a helper has: the length of a row of `sides`.
fn lanes(signature: &syn::Signature) -> Option<usize> {
    let sides = signature.inputs.iter().find_map(|own| match own {
        syn::FnArg::Typed(own) if matches!(&*own.pat, syn::Pat::Ident(name) if name.ident == "sides") => {
            Some(&*own.ty)
        }
        _ => None,
    })?;
    let syn::Type::Reference(sides) = sides else {
        return None;
    };
    let syn::Type::Array(sides) = &*sides.elem else {
        return None;
    };
    match &*sides.elem {
        syn::Type::Array(row) => number(&row.len),
        _ => None,
    }
}

/// What the loops of a helper repeat for every column; it does nothing else than that.
fn repeated<'a>(signature: &syn::Signature, body: &'a syn::Block) -> Option<Vec<&'a syn::Block>> {
    let is_local = |own: &&syn::Stmt| matches!(own, syn::Stmt::Local(_));
    let n_locals = body.stmts.iter().take_while(is_local).count();
    let [loops @ .., syn::Stmt::Expr(syn::Expr::Path(_), None)] = &body.stmts[n_locals..] else {
        return None;
    };
    let is_short = lanes(signature).is_some_and(|lanes| (2..=8).contains(&lanes));
    let loops = loops.iter().map(|own| match own {
        syn::Stmt::Expr(syn::Expr::ForLoop(own), None) => columns(own),
        _ => None,
    });
    let loops: Option<Vec<_>> = loops.collect();
    loops.filter(|loops| is_short && !loops.is_empty())
}

/// Asserts that a module's functions are straight lines; how many there are, and how many stages and helpers of these.
fn assert_straight(name: &str, text: &str) -> (usize, usize) {
    let file = syn::parse_file(text).expect("what is generated is Rust");
    let mut anywhere = Anywhere::default();
    anywhere.visit_file(&file);
    assert!(anywhere.0.is_empty(), "{name}: {:?}", anywhere.0);
    let (mut n_functions, mut n_parts) = (0, 0);
    for item in &file.items {
        // The free functions, and what prepares the parameters.
        let bodies: Vec<(String, &syn::Signature, &syn::Block)> = match item {
            syn::Item::Fn(function) => vec![(
                function.sig.ident.to_string(),
                &function.sig,
                &function.block,
            )],
            syn::Item::Impl(implementation) if implementation.trait_.is_none() => {
                let items = implementation.items.iter();
                let methods = items.filter_map(|item| match item {
                    syn::ImplItem::Fn(method) if method.sig.ident == "new" => {
                        Some(("Prepared::new".to_owned(), &method.sig, &method.block))
                    }
                    _ => None,
                });
                methods.collect()
            }
            _ => Vec::new(),
        };
        for (function, signature, body) in bodies {
            let mut found = Found::default();
            if is_helper(&function) {
                found.lane = Some("lane");
                let repeated = repeated(signature, body);
                let repeated = repeated.expect("a helper repeats straight lines");
                for block in repeated {
                    found.visit_block(block);
                }
            } else {
                found.visit_block(body);
            }
            assert!(
                found.what.is_empty(),
                "{name}, {function}: {:?}",
                found.what
            );
            n_parts += usize::from(is_part(&function));
            n_functions += usize::from(!is_part(&function));
        }
    }
    (n_functions, n_parts)
}

#[test]
fn generated_functions_are_straight_lines_of_arithmetic() {
    for (name, text) in modules() {
        let (n_functions, _) = assert_straight(&name, &text);
        assert_eq!(n_functions, CATALOGUE.len() + 1, "{name}");
    }
}

#[test]
fn so_are_the_stages_of_a_long_function() {
    let options = Options {
        functions: Functions::Named(vec!["forward_dynamics_pivots".to_owned()]),
        ..Options::default()
    };
    let source = Source::new("tree12.toml", include_str!("../../reference/tree12.toml"));
    let module = generate(&source, "tree12", &options, &no_includes).expect("a right description");
    let (n_functions, n_stages) = assert_straight("tree12", &module.source);
    // What every module has: its preparation, and the rates of coordinates.
    assert_eq!(n_functions, 3);
    assert!(n_stages > 2, "{n_stages}");
}

#[test]
fn so_are_the_helpers_of_a_function_but_for_a_loop_over_four_columns() {
    let options = Options {
        functions: Functions::Named(vec!["d(forward_dynamics)/d(q, u)".to_owned()]),
        reading: Reading {
            base: Some(Base::Free),
            ..Reading::default()
        },
        ..Options::default()
    };
    let text = include_str!("../../robots/solo12/solo12.urdf");
    let source = Source::new("solo12.urdf", text);
    let module = generate(&source, "solo12", &options, &no_includes).expect("a robot");
    let (n_functions, n_helpers) = assert_straight("solo12", &module.source);
    // What modules with quaternions have: their preparation, the rates of coordinates, and what makes quaternions unit ones.
    assert_eq!(n_functions, 4);
    assert!(n_helpers > 2, "{n_helpers}");
}

/// The ways in which a user's crate can take a module in: attributes of the crate, and the module's declaration.
const CRATES: [(&str, &str, &str); 4] = [
    ("file", "", "#[path = \"TEXT\"] pub mod system;"),
    ("include", "", "pub mod system { include!(\"TEXT\"); }"),
    (
        "without_std",
        "#![no_std]",
        "#[path = \"TEXT\"] pub mod system;",
    ),
    (
        "without_unsafe",
        "#![forbid(unsafe_code)]",
        "pub mod system { include!(\"TEXT\"); }",
    ),
];

/// A package with one module, which calls a function so that it is compiled and not only read.
fn package(
    folder: &Path,
    name: &str,
    edition: &str,
    attributes: &str,
    declaration: &str,
    text: &Path,
) {
    let runtime = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let runtime = fs::canonicalize(runtime).expect("the workspace is there");
    let runtime = runtime.display();
    let source = folder.join(name).join("src");
    fs::create_dir_all(&source).expect("the folder is ours");
    let manifest = format!(
        "[package]\nname = \"{name}\"\nedition = \"{edition}\"\n\n[dependencies]\nkane = {{ path = '{runtime}', default-features = false }}\n"
    );
    fs::write(folder.join(name).join("Cargo.toml"), manifest).expect("the folder is ours");
    let declaration = declaration.replace("TEXT", &text.display().to_string().replace('\\', "/"));
    let library = format!(
        "//! One module.\n#![deny(warnings)]\n{attributes}\n\n/// The system.\n{declaration}\n\n\
        /// Forward dynamics of it.\n\
        pub fn call(q: &[f64; system::NQ], u: &[f64; system::NU], u_dot: &mut [f64; system::NU]) {{\n    \
        system::forward_dynamics(&system::Prepared::nominal(), q, u, u, u_dot);\n}}\n"
    );
    fs::write(source.join("lib.rs"), library).expect("the folder is ours");
}

#[test]
fn modules_compile_without_warnings_wherever_they_are_taken_in() {
    let folder = tempfile::tempdir().expect("a folder for the packages");
    let runtime_values = BAKED_RUNTIME_CHANGED[1];
    // One without parameters, one with; the smallest of the random systems is enough.
    let texts = [("baked", RANDOM[2]), ("runtime", runtime_values)].map(|(name, compiled)| {
        let path = folder.path().join(format!("{name}.rs"));
        let text = module(compiled.name, compiled.model, Formulation::Cheapest);
        fs::write(&path, text).expect("the folder is ours");
        path
    });
    let mut members = Vec::new();
    for edition in ["2021", "2024"] {
        for (place, (kind, attributes, declaration)) in CRATES.into_iter().enumerate() {
            let name = format!("{kind}_{edition}");
            package(
                folder.path(),
                &name,
                edition,
                attributes,
                declaration,
                &texts[place % 2],
            );
            members.push(name);
        }
    }
    let manifest = format!("[workspace]\nresolver = \"3\"\nmembers = {members:?}\n");
    fs::write(folder.path().join("Cargo.toml"), manifest).expect("the folder is ours");
    let output = Command::new(env!("CARGO"))
        .args(["build", "--offline", "--workspace"])
        .current_dir(folder.path())
        .env("CARGO_TARGET_DIR", folder.path().join("target"))
        .env("CARGO_PROFILE_DEV_DEBUG", "0")
        .env_remove("RUSTFLAGS")
        .output()
        .expect("cargo starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    assert!(!said.contains("warning"), "{said}");
}

#[test]
fn the_same_description_gives_the_same_text() {
    for compiled in [RANDOM[0], BAKED_RUNTIME_CHANGED[1]] {
        let [one, other] =
            [0; 2].map(|_| module(compiled.name, compiled.model, Formulation::Cheapest));
        assert!(one == other, "{}", compiled.name);
    }
}
