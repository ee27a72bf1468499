//! Generated functions, evaluated as they are written: what a changed token does shows without a compiler.
//!
//! In: the text of a function, and what it is given, of several states side by side. Out: what it writes. The text is
//! straight-line code of few forms; any other form is a panic here.

use std::collections::BTreeMap;

use syn::{BinOp, Block, Expr, FnArg, Lit, Member, Pat, Stmt, UnOp};

/// One number of each state.
pub(super) type Numbers = Vec<f64>;

/// Numbers by the text of their place: `q[3]`, `p.hub_k1`, `m[0][1]`.
pub(super) type Places = BTreeMap<String, Numbers>;

/// A function of a module.
pub(super) struct Function {
    outputs: Vec<String>,
    body: Block,
}

impl Function {
    pub(super) fn parse(text: &str) -> Self {
        let function: syn::ItemFn = syn::parse_str(text).unwrap();
        let outputs = function.sig.inputs.iter().filter_map(|input| match input {
            FnArg::Typed(typed) => match &*typed.ty {
                syn::Type::Reference(reference) if reference.mutability.is_some() => {
                    Some(name(&typed.pat))
                }
                _ => None,
            },
            FnArg::Receiver(_) => unreachable!("free functions alone are parsed"),
        });
        Self {
            outputs: outputs.collect(),
            body: *function.block,
        }
    }

    /// The outputs, each entry by entry.
    pub(super) fn outputs(&self, given: &Places, n_states: usize) -> Vec<Vec<Numbers>> {
        let mut state = State::new(given, n_states);
        state.run(&self.body);
        let outputs = self.outputs.iter().map(|name| {
            let is_own = |place: &&String| place.split('[').next() == Some(name);
            let mut places: Vec<&String> = state.written.keys().filter(is_own).collect();
            places.sort_by_key(|place| indexes(place));
            let entries = places.into_iter().map(|place| state.written[place].clone());
            entries.collect()
        });
        outputs.collect()
    }

    /// The fields of what it returns, as those of `p`.
    pub(super) fn prepared(&self, given: &Places, n_states: usize) -> Places {
        let mut state = State::new(given, n_states);
        let Some(Expr::Struct(fields)) = state.run(&self.body) else {
            unreachable!("it returns a structure")
        };
        let fields = fields.fields.iter().filter_map(|field| {
            let Member::Named(name) = &field.member else {
                return None;
            };
            let is_number =
                !matches!(&field.expr, Expr::Path(path) if path.path.segments.len() > 1);
            is_number.then(|| (format!("p.{name}"), state.value(&field.expr)))
        });
        fields.collect()
    }
}

/// What is known where a function has come to.
struct State<'g> {
    given: &'g Places,
    written: Places,
    n_states: usize,
}

impl<'g> State<'g> {
    fn new(given: &'g Places, n_states: usize) -> Self {
        Self {
            given,
            written: Places::new(),
            n_states,
        }
    }

    /// The value that the block ends with, if it has one.
    fn run<'b>(&mut self, block: &'b Block) -> Option<&'b Expr> {
        for statement in &block.stmts {
            match statement {
                Stmt::Local(local) => {
                    if let Some(init) = &local.init {
                        self.bind(&local.pat, &init.expr);
                    }
                }
                Stmt::Expr(Expr::Assign(assign), _) => match &*assign.left {
                    Expr::Tuple(pair) => {
                        let names: Vec<String> = pair.elems.iter().map(place).collect();
                        self.bind_pair(&names, &assign.right);
                    }
                    left => {
                        let value = self.value(&assign.right);
                        self.written.insert(place(left), value);
                    }
                },
                Stmt::Expr(value, None) => return Some(value),
                Stmt::Expr(Expr::Call(call), Some(_)) => {
                    let (Expr::Reference(left), right) = (&call.args[0], &call.args[1]) else {
                        unreachable!("no function has such a form")
                    };
                    assert_eq!(place(&call.func), "kane::store");
                    let value = self.value(right);
                    self.written.insert(place(&left.expr), value);
                }
                _ => unreachable!("no function has such a form"),
            }
        }
        None
    }

    fn bind(&mut self, pattern: &Pat, value: &Expr) {
        if let Pat::Tuple(pair) = pattern {
            let names: Vec<String> = pair.elems.iter().map(name).collect();
            self.bind_pair(&names, value);
        } else {
            let value = self.value(value);
            self.written.insert(name(pattern), value);
        }
    }

    /// Sines and cosines, of one angle or of a list.
    fn bind_pair(&mut self, names: &[String], value: &Expr) {
        let Expr::Call(call) = value else {
            unreachable!("no function has such a form")
        };
        let angles: Vec<(String, &Expr)> = match &call.args[0] {
            Expr::Array(list) => {
                let places = list.elems.iter().enumerate();
                places
                    .map(|(place, angle)| (format!("[{place}]"), angle))
                    .collect()
            }
            angle => vec![(String::new(), angle)],
        };
        for (index, angle) in angles {
            let angle = self.value(angle);
            for (name, of) in names.iter().zip([libm::sin, libm::cos]) {
                let values = angle.iter().map(|angle| of(*angle));
                self.written
                    .insert(format!("{name}{index}"), values.collect());
            }
        }
    }

    fn value(&self, value: &Expr) -> Numbers {
        match value {
            Expr::Paren(inner) => self.value(&inner.expr),
            Expr::Lit(literal) => vec![number(&literal.lit); self.n_states],
            Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => {
                self.value(&unary.expr).iter().map(|x| -x).collect()
            }
            Expr::Binary(binary) => {
                let (left, right) = (self.value(&binary.left), self.value(&binary.right));
                let of: fn(f64, f64) -> f64 = match binary.op {
                    BinOp::Add(_) => |a, b| a + b,
                    BinOp::Sub(_) => |a, b| a - b,
                    BinOp::Mul(_) => |a, b| a * b,
                    BinOp::Div(_) => |a, b| a / b,
                    _ => unreachable!("no function has such a form"),
                };
                left.iter().zip(&right).map(|(a, b)| of(*a, *b)).collect()
            }
            Expr::Call(call) => {
                let of: fn(f64) -> f64 = match place(&call.func).as_str() {
                    "R::from_f64" => |x| x,
                    "R::abs" => f64::abs,
                    "R::sqrt" => f64::sqrt,
                    other => unreachable!("{other}"),
                };
                self.value(&call.args[0]).iter().map(|x| of(*x)).collect()
            }
            value => {
                let place = place(value);
                let known = self.written.get(&place).or_else(|| self.given.get(&place));
                known
                    .unwrap_or_else(|| unreachable!("{place} is not known"))
                    .clone()
            }
        }
    }
}

/// The number of a literal.
pub(super) fn number(literal: &Lit) -> f64 {
    match literal {
        Lit::Float(number) => number.base10_parse().unwrap(),
        Lit::Int(number) => number.base10_parse().unwrap(),
        _ => unreachable!("no function has such a form"),
    }
}

/// The text of a place.
pub(super) fn place(expr: &Expr) -> String {
    match expr {
        Expr::Path(path) => {
            let names = path.path.segments.iter().map(|one| one.ident.to_string());
            names.collect::<Vec<_>>().join("::")
        }
        Expr::Field(field) => {
            let Member::Named(name) = &field.member else {
                unreachable!("no tuples are given")
            };
            format!("{}.{name}", place(&field.base))
        }
        Expr::Index(index) => {
            let Expr::Lit(number) = &*index.index else {
                unreachable!("indexes are constants")
            };
            let Lit::Int(number) = &number.lit else {
                unreachable!("indexes are whole")
            };
            format!("{}[{number}]", place(&index.expr))
        }
        Expr::Unary(unary) if matches!(unary.op, UnOp::Deref(_)) => place(&unary.expr),
        Expr::Infer(_) => "_".to_owned(),
        _ => unreachable!("no function has such a form"),
    }
}

fn name(pattern: &Pat) -> String {
    match pattern {
        Pat::Ident(name) => name.ident.to_string(),
        Pat::Type(typed) => name(&typed.pat),
        Pat::Wild(_) => "_".to_owned(),
        _ => unreachable!("no function has such a form"),
    }
}

/// The numbers in brackets of a place.
fn indexes(place: &str) -> Vec<usize> {
    let indexes = place.split('[').skip(1);
    let indexes = indexes.map(|index| index.trim_end_matches(']').parse().unwrap());
    indexes.collect()
}
