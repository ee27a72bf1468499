//! The module's constants, as constant tables of a header.

use super::{
    names::Names,
    text::{once, table},
};
use crate::{
    functions::{CompactBlock, Packed},
    listing::{BaseTerm, Constant, Data, Facts, Frame},
};

/// The tables, in the order of the module's constants; what is empty is left out.
pub(super) fn tables(facts: &Facts, prefix: &str, names: &Names) -> Vec<String> {
    let mut constants = facts.all_constants();
    constants.extend(facts.prescribed_constant());
    let mut tables: Vec<String> = constants
        .iter()
        .filter_map(|constant| of(constant, prefix, names))
        .collect();
    if !facts.frames.is_empty() {
        tables.insert(0, once("KANE_FRAME", FRAME));
    }
    if facts.base_parameters.is_some() {
        tables.insert(
            0,
            once("KANE_BASE_TERM", &BASE_TERM.replace("INERTIAL", INERTIAL)),
        );
    }
    if facts
        .patterns
        .iter()
        .any(|pattern| !pattern.entries.is_empty())
    {
        tables.insert(0, once("KANE_BLOCK", BLOCK));
    }
    tables
}

/// What the tables need where there is no limit, before anything that is declared for C++: an include only for compilers without the constant.
pub(super) fn no_limit(facts: &Facts) -> Option<String> {
    let limits = &facts.limits;
    let mut all = [
        &limits.lower,
        &limits.upper,
        &limits.velocity,
        &limits.effort,
    ]
    .into_iter();
    let has_none = all.any(|values| values.iter().any(|value| value.is_infinite()));
    has_none.then(|| NO_LIMIT.to_owned())
}

const NO_LIMIT: &str = "\
/// What stands where there is no limit: infinity.
#ifndef KANE_NO_LIMIT
#ifdef __GNUC__
#define KANE_NO_LIMIT __builtin_huge_val()
#else
#include <math.h>
#define KANE_NO_LIMIT HUGE_VAL
#endif
#endif
";

fn of(constant: &Constant<'_>, prefix: &str, names: &Names) -> Option<String> {
    let name = constant.name;
    // The length of what has it in its type in Rust.
    let own = format!("{prefix}{name}_LEN");
    let (declared, entries): (String, Vec<String>) = match &constant.data {
        Data::Texts(length, texts) => (
            format!("char *const {prefix}{name}[{prefix}{length}]"),
            texts.iter().map(|text| string(text)).collect(),
        ),
        Data::Numbers(length, values) => (
            format!("double {prefix}{name}[{prefix}{length}]"),
            values.iter().map(|value| number(*value)).collect(),
        ),
        Data::Frames(frames) => (
            format!("kane_frame {prefix}{name}[{own}]"),
            frames.iter().map(frame).collect(),
        ),
        Data::Terms(terms) => (
            format!("kane_base_term {prefix}{name}[{own}]"),
            terms.iter().map(term).collect(),
        ),
        Data::Integers(length, values) => (
            format!("int {prefix}{name}[{prefix}{length}]"),
            values.iter().map(usize::to_string).collect(),
        ),
        Data::Truths(length, values) => (
            format!("int {prefix}{name}[{prefix}{length}]"),
            values
                .iter()
                .map(|value| u8::from(*value).to_string())
                .collect(),
        ),
        Data::Places(length, places) => (
            format!("int {prefix}{name}[{prefix}{length}][2]"),
            places.iter().map(|place| list(place)).collect(),
        ),
        Data::Blocks(blocks) => (
            format!("kane_block {prefix}{name}[{own}]"),
            blocks.iter().map(block).collect(),
        ),
        // Sizes stand above; the places of joints are enumerations.
        Data::Size(_) | Data::Hash(_) | Data::Text(_) | Data::Joints(..) | Data::Costs(_) => {
            return None;
        }
    };
    let is_truth = matches!(constant.data, Data::Truths(..));
    let mut doc = names.renamed(&constant.doc, &[]);
    if is_truth {
        doc += " 1 is true, 0 false.";
    }
    if name == Packed::Regressor.places_constant() {
        doc = format!("{doc} A body's ten parameters, counted from 0, are {INERTIAL}.");
    }
    let length = if declared.ends_with(&format!("[{own}]")) {
        let n_entries = entries.len();
        format!("/// The number of entries of `{prefix}{name}`.\n#define {own} {n_entries}\n")
    } else {
        String::new()
    };
    (!entries.is_empty()).then(|| length + &table(&doc, &declared, entries.into_iter()))
}

const FRAME: &str = "\
/// A frame that is part of a body: its name; the body, counted from 0, or -1 for the inertial frame; the matrix from the body's axes
/// to the frame's; the position of its origin from the body's, the body's axes, m.
typedef struct kane_frame {
    const char *name;
    int body;
    double rotation[3][3];
    double position[3];
} kane_frame;
";

/// The inertial parameters of a body in the order of a regressor's columns.
const INERTIAL: &str = "m, m c_x, m c_y, m c_z, I_xx, I_xy, I_yy, I_xz, I_yz, I_zz";

const BASE_TERM: &str = "\
/// A term of a base parameter: the places of the base parameter, of the body, and of the parameter among the body's ten, all counted
/// from 0; what that is multiplied with. The ten are INERTIAL.
typedef struct kane_base_term {
    int base;
    int body;
    int parameter;
    double factor;
} kane_base_term;
";

const BLOCK: &str = "\
/// Columns that belong to one body and to speeds in a row, all counted from 0: the body whose velocity it is, the partition,
/// of body J's angles J and of its translations NB + J, the first speed, how many speeds and columns, and the place of the first column.
typedef struct kane_block {
    int body;
    int partition;
    int speed;
    int columns;
    int first;
} kane_block;
";

fn block(block: &CompactBlock) -> String {
    list(&[
        block.body,
        block.partition,
        block.speed,
        block.columns,
        block.first,
    ])
}

fn list(entries: &[usize]) -> String {
    let entries: Vec<String> = entries.iter().map(ToString::to_string).collect();
    format!("{{{}}}", entries.join(", "))
}

fn term(term: &BaseTerm) -> String {
    let BaseTerm {
        base,
        body,
        parameter,
        factor,
    } = *term;
    format!("{{{base}, {body}, {parameter}, {}}}", number(factor))
}

fn frame(frame: &Frame) -> String {
    let body = frame
        .body
        .map_or_else(|| "-1".to_owned(), |body| body.to_string());
    let vector = |row: &[f64; 3]| format!("{{{}}}", row.map(number).join(", "));
    let rows = frame.rotation.each_ref().map(vector).join(", ");
    let (name, position) = (string(&frame.name), vector(&frame.position));
    format!("{{{name}, {body}, {{{rows}}}, {position}}}")
}

fn number(value: f64) -> String {
    if value.is_infinite() {
        let sign = if value < 0.0 { "-" } else { "" };
        return format!("{sign}KANE_NO_LIMIT");
    }
    format!("{value:?}")
}

/// A literal; bytes that are no plain letters are written by their octal numbers.
fn string(text: &str) -> String {
    let byte = |byte: u8| match byte {
        b'"' | b'\\' | b'?' => format!("\\{}", char::from(byte)),
        b' '..=b'~' => char::from(byte).to_string(),
        byte => format!("\\{byte:03o}"),
    };
    format!("\"{}\"", text.bytes().map(byte).collect::<String>())
}
