//! The statements of a function.

use syn::Stmt;

use super::{
    declarations::Declarations,
    expression::Writer,
    syntax,
    text::{comment, ident},
};
use crate::listing::{Entry, Expression, LocalId, Statement};

/// All of them.
pub(super) fn of(writer: &Writer<'_>) -> Vec<Stmt> {
    those(writer, |_| true, |_| None)
}

/// All of them, and behind each local that is kept the statement that does so.
pub(super) fn keeping(writer: &Writer<'_>, keep: impl Fn(LocalId) -> Option<Stmt>) -> Vec<Stmt> {
    those(writer, |_| true, keep)
}

/// Those that assign locals.
pub(super) fn without_stores(writer: &Writer<'_>) -> Vec<Stmt> {
    let is_wanted = |statement: &Statement| {
        !matches!(statement, Statement::Store { .. } | Statement::Heading(_))
    };
    those(writer, is_wanted, |_| None)
}

fn those(
    writer: &Writer<'_>,
    is_wanted: impl Fn(&Statement) -> bool,
    keep: impl Fn(LocalId) -> Option<Stmt>,
) -> Vec<Stmt> {
    let code = writer.code;
    let declarations = Declarations::of(code);
    let mut printed = Vec::with_capacity(code.statements.len());
    for statement in code.statements.iter().filter(|one| is_wanted(one)) {
        for together in statement.assigned().filter_map(|id| declarations.at(id)) {
            let names: Vec<_> = together.iter().map(|&id| Some(writer.local(id))).collect();
            printed.push(syntax::declare(syntax::pattern(&names), None));
        }
        print(writer, &declarations, statement, &mut printed);
        printed.extend(statement.assigned().filter_map(&keep));
    }
    printed
}

fn print(
    writer: &Writer<'_>,
    declarations: &Declarations,
    statement: &Statement,
    printed: &mut Vec<Stmt>,
) {
    let assign = |locals: &[Option<LocalId>], value| {
        let names: Vec<_> = locals
            .iter()
            .map(|id| id.map(|id| writer.local(id)))
            .collect();
        if declarations.are_apart() {
            syntax::assign(syntax::places(&names), value)
        } else {
            syntax::declare(syntax::pattern(&names), Some(value))
        }
    };
    match statement {
        Statement::Assign { local, value } => {
            printed.push(assign(&[Some(*local)], writer.expression(value)));
        }
        Statement::SinCos {
            angle,
            sine,
            cosine,
        } => {
            let value = writer.call("sin_cos", std::slice::from_ref(angle));
            printed.push(assign(&[*sine, *cosine], value));
        }
        Statement::SinCosArray {
            angles,
            sines,
            cosines,
        } => {
            let code = writer.code;
            let names = [sines, cosines].map(|&id| code.array(id).name.as_str());
            printed.push(sin_cos_array(writer, names, angles));
        }
        Statement::Call {
            helper,
            shared,
            sides,
            solved,
        } => {
            let value = writer.helped(*helper, shared.iter().chain([sides]));
            let solved = ident(&writer.code.array(*solved).name);
            printed.push(syntax::declare(
                syntax::pattern(&[Some(solved)]),
                Some(value),
            ));
        }
        Statement::StoreSinCos {
            angles,
            sines,
            cosines,
        } => {
            // Each call hides the arrays of the one before.
            let names = ["sines", "cosines"];
            printed.push(sin_cos_array(writer, names, angles));
            for (name, places) in names.into_iter().zip([sines, cosines]) {
                let places = places.iter().map(|place: &Entry| writer.entry(place));
                let array = syntax::name(&ident(name));
                printed.push(syntax::assign(syntax::array(places), array));
            }
        }
        Statement::Store {
            place,
            value,
            is_apart,
        } => {
            let (place, value) = (writer.entry(place), writer.expression(value));
            printed.push(if *is_apart {
                syntax::store(place, value)
            } else {
                syntax::assign(place, value)
            });
        }
        Statement::Heading(words) => printed.push(comment(words)),
    }
}

fn sin_cos_array(writer: &Writer<'_>, names: [&str; 2], angles: &[Expression]) -> Stmt {
    let angles = angles.iter().map(|angle| writer.expression(angle));
    let value = syntax::call(syntax::of_scalar("sin_cos_array"), [syntax::array(angles)]);
    let pattern = syntax::pattern(&names.map(|name| Some(ident(name))));
    syntax::declare(pattern, Some(value))
}
