//! One function: documentation, signature, statements, stores, and the trait that holds it.

use proc_macro2::{Ident, Literal};
use quote::quote;
use syn::{Expr, Item, ItemFn, parse_quote};

use super::{
    Emittable, Module, allow_generated, allow_unused, doc,
    expression::Writer,
    ident, signature,
    statements::{self, Stores},
    syntax,
};
use crate::{
    expr::Input,
    functions::{Function, Shape},
    program::{self, Groups, Operand, Origin, Place, Program, ValueId},
    tree::Tree,
};

/// The most zeros that are stored side by side before a fence. More the compiler makes a call of `memset`, on the smallest
/// of processors already where they have 32 bytes.
const MOST_ZEROS: usize = 4;

/// The items of one function, in order: its pattern, itself, its trait.
pub(super) fn items(module: &Module<'_>, emittable: &Emittable) -> Vec<Item> {
    let (tree, fields) = (module.tree, &module.fields);
    let alone = emittable.function.alone();
    // Two functions of one compact output have its pattern in common.
    let is_first = |function: &&Function| {
        let plain = |other: &Emittable| other.function.alone().map(|other| other.name);
        alone.is_some()
            || module
                .functions
                .iter()
                .all(|other| plain(other) != Some(function.name))
    };
    let compact = emittable.function.compact().filter(is_first);
    let mut items = compact.map_or_else(Vec::new, |function| pattern(emittable, function));
    items.push(free_function(tree, emittable, fields));
    let in_trait = alone.and_then(|function| Some((function, function.trait_name?)));
    items.extend(in_trait.map(|(function, name)| trait_impl(emittable, function, name)));
    items
}

fn free_function(tree: &Tree, emittable: &Emittable, fields: &[String]) -> Item {
    let Emittable {
        function,
        program,
        formulation,
        operations,
        ..
    } = emittable;
    let groups = Groups::of(program);
    let outputs = function.outputs().into_iter();
    let outputs: Vec<String> = outputs.map(|output| output.name.into_owned()).collect();
    let place = Place::Function {
        fields,
        outputs: &outputs,
    };
    let names = program::names(program, &groups, tree, place);
    let writer = Writer {
        program,
        groups: &groups,
        names: &names,
    };
    let stores = stores(&writer, targets(tree, emittable));
    let has_fences = stores.has_fences;
    let statements = statements::of(program, &groups, &names, &[], stores);
    let mut lines = function.doc();
    lines.push(String::new());
    let how = if function.formulations().len() > 1 {
        format!("; formulation: {}", formulation.name())
    } else {
        String::new()
    };
    lines.push(format!("Operations: {operations}{how}."));
    if program.fused() > 0 {
        let fused = program.fused();
        lines.push(format!(
            "Of the multiplications and additions {fused} each are fused."
        ));
    }
    if has_fences {
        lines.push("A `compiler_fence` is no instruction: it keeps runs of zeros from becoming calls of `memset`.".to_owned());
    }
    let (doc, allow) = (doc(lines), allow_generated());
    let name = ident(&function.name());
    let arguments = function.signature().arguments;
    let arguments = arguments.iter().map(signature::declared);
    let mut item: ItemFn = parse_quote! {
        #doc
        #allow
        #[inline(never)]
        pub fn #name<R: kane::Real>(#(#arguments),*) {}
    };
    item.block.stmts = statements;
    Item::Fn(item)
}

/// What is stored where, with a fence wherever too many zeros would stand side by side.
fn stores(writer: &Writer<'_>, targets: Vec<Expr>) -> Stores {
    let program = writer.program;
    let mut stores = Stores::default();
    let mut n_zeros = 0;
    for (target, &store) in targets.into_iter().zip(&program.stores) {
        let statement = syntax::assign(target, writer.operand(store));
        n_zeros = if store == Operand::Number(0.0) {
            n_zeros + 1
        } else {
            0
        };
        if n_zeros > MOST_ZEROS {
            stores.of_constants.push(parse_quote! {
                core::sync::atomic::compiler_fence(core::sync::atomic::Ordering::SeqCst);
            });
            stores.has_fences = true;
            n_zeros = 1;
        }
        match store.value().filter(|&id| !is_field(program, id)) {
            Some(id) => stores.of_values.entry(id).or_default().push(statement),
            None => stores.of_constants.push(statement),
        }
    }
    stores
}

/// The place of every store: the entries of one output after the other.
fn targets(tree: &Tree, emittable: &Emittable) -> Vec<Expr> {
    let n_columns = emittable.program.stores.len() / 3;
    let mut targets = Vec::with_capacity(emittable.program.stores.len());
    for output in emittable.function.outputs() {
        let name = ident(&output.name);
        let lengths = output.shape.lengths(tree, n_columns);
        let size = lengths.iter().product();
        targets.extend((0..size).map(|place| target(&name, &lengths, place)));
    }
    targets
}

/// True for a field of `Prepared`, which needs no statement before it is stored.
fn is_field(program: &Program, id: ValueId) -> bool {
    matches!(program.value(id).origin, Origin::Input(Input::Prepared(_)))
}

/// The place of an output's entry: `m[0][3]`.
fn target(output: &Ident, lengths: &[usize], place: usize) -> Expr {
    let output = syntax::name(output);
    if lengths.is_empty() {
        return syntax::dereferenced(output);
    }
    let mut strides = vec![1; lengths.len()];
    for axis in (1..lengths.len()).rev() {
        strides[axis - 1] = strides[axis] * lengths[axis];
    }
    let indexes = strides
        .iter()
        .zip(lengths)
        .map(|(stride, length)| place / stride % length);
    indexes.fold(output, syntax::index)
}

/// The pattern of a compact output, as constants.
fn pattern(emittable: &Emittable, function: &Function) -> Vec<Item> {
    let name = function.name;
    let (columns, blocks) = (
        ident(&function.columns_constant()),
        ident(&function.blocks_constant()),
    );
    let n_columns = Literal::usize_unsuffixed(emittable.program.stores.len() / 3);
    let n_blocks = Literal::usize_unsuffixed(emittable.blocks.len());
    let entries = emittable.blocks.iter().map(|block| {
        let [body, partition, speed, columns, first] =
            [block.body, block.partition, block.speed, block.columns, block.first].map(Literal::usize_unsuffixed);
        quote!(kane::Block { body: #body, partition: #partition, speed: #speed, columns: #columns, first: #first })
    });
    let allow = allow_unused();
    let columns_doc = doc([format!("Number of columns that `{name}` writes.")]);
    let blocks_doc = doc([format!(
        "The non-zero partitions that `{name}` writes, body after body."
    )]);
    vec![
        parse_quote!(#columns_doc #allow pub const #columns: usize = #n_columns;),
        parse_quote!(#blocks_doc #allow pub const #blocks: [kane::Block; #n_blocks] = [#(#entries),*];),
    ]
}

/// The runtime crate's trait for the function.
fn trait_impl(emittable: &Emittable, function: &Function, trait_name: &str) -> Item {
    let (trait_name, method) = (ident(trait_name), ident(function.name));
    let signature = emittable.function.signature();
    // The first one is `self`.
    let arguments = signature.arguments.iter().skip(1);
    let names = arguments.clone().map(|argument| ident(&argument.name));
    let output_type = arguments.clone().next_back();
    let output_type = output_type.map(|output| signature::held(output, "R"));
    let arguments = arguments.map(signature::declared);
    let associated = match function.outputs[0].shape {
        Shape::SPEED_MATRIX => quote!(type Matrix = #output_type;),
        Shape::SPEED_PAIRS => quote! {
            type Entries = #output_type;
            const PLACES: &'static [[usize; 2]] = MASS_MATRIX_PACKED_PLACES;
        },
        Shape::COLUMNS => {
            let columns = ident(&format!(
                "{}Columns",
                function.trait_name.expect("compact functions have traits")
            ));
            let blocks = ident(&function.blocks_constant());
            quote! {
                type #columns = #output_type;
                const #blocks: &'static [kane::Block] = &#blocks;
            }
        }
        _ => quote!(),
    };
    parse_quote! {
        impl<R: kane::Real> kane::functions::#trait_name<R> for Prepared<R> {
            #associated
            #[inline]
            fn #method(&self, #(#arguments),*) {
                self::#method(self, #(#names),*);
            }
        }
    }
}
