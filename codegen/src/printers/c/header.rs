//! The header: what a module's functions are in C, from the table that the file with their Rust side is written from.

use std::{borrow::Cow, collections::BTreeSet};

use super::{
    data,
    names::Names,
    rules::{RULES, SCALARS, scalar_type, symbol},
    runtime,
    text::once,
};
use crate::{
    functions::{Access, Declared, Element, Length, Signature},
    listing::{
        Facts, Module, Size,
        constants::{COORDINATES, SPEEDS},
        nominal,
    },
    taken::Taken,
    words::{C_INPUT, C_STRUCTURES},
};

/// The text of the header of the module `name`, for C99 and C++.
pub fn text(module: &Module, name: &str) -> String {
    let facts = &module.facts;
    let runtime = runtime::of(module);
    let own = module.all().map(|function| &function.signature);
    let runtime = runtime.iter().map(|function| &function.signature);
    let signatures: Vec<&Signature> = own.chain(runtime).collect();
    let header = Header {
        facts,
        name,
        prefix: format!("{}_", name.to_uppercase()),
        empty: empty(facts, &signatures),
        names: Names::of(facts, name, &signatures),
    };
    let guard = format!("KANE_{}H", header.prefix);
    let mut sections = vec![
        header.opening(),
        format!("#ifndef {guard}\n#define {guard}\n"),
    ];
    sections.extend(data::no_limit(facts));
    sections.push("#ifdef __cplusplus\nextern \"C\" {\n#endif\n".to_owned());
    sections.push(header.input());
    sections.push(header.sizes());
    sections.extend(header.places());
    sections.extend(data::tables(&module.facts, &header.prefix, &header.names));
    let mut arguments = signatures.iter().flat_map(|one| &one.arguments);
    if arguments.any(|one| one.element == Element::Load) {
        sections.push(once("KANE_LOAD", &loads()));
    }
    sections.extend(header.structures());
    sections.extend(signatures.iter().map(|one| header.prototypes(one)));
    sections.push("#ifdef __cplusplus\n}\n#endif\n\n#endif\n".to_owned());
    sections.join("\n")
}

/// The lengths that are zero, of what the header declares.
fn empty<'a>(facts: &'a Facts, signatures: &[&Signature]) -> BTreeSet<&'a str> {
    let empty = facts.sizes.0.iter().filter(|size| {
        let patterns = facts.patterns.iter().map(|pattern| &pattern.columns);
        let own = patterns.chain(facts.frame_speeds.iter().map(|frame| &frame.length));
        let own = own.chain(facts.entries.iter().map(|entries| &entries.length));
        let arguments = signatures.iter().flat_map(|one| &one.arguments);
        let lengths = arguments.flat_map(|argument| &argument.lengths);
        let constants = lengths.filter_map(Length::constant);
        let mut named = own.map(String::as_str).chain(constants);
        size.value == 0 && named.any(|length| length == size.name)
    });
    empty.map(|size| size.name.as_str()).collect()
}

struct Header<'a> {
    facts: &'a Facts,
    /// The module's name, with which those of types and functions begin.
    name: &'a str,
    /// With what those of constants begin.
    prefix: String,
    /// The lengths that are zero.
    empty: BTreeSet<&'a str>,
    /// What its texts speak of.
    names: Names,
}

/// Names of places, an enumeration in C.
struct Places<'a> {
    /// What the names begin with.
    kind: &'static str,
    doc: Cow<'static, str>,
    names: Vec<&'a str>,
    /// What is said of each, where something is.
    notes: Vec<String>,
}

impl Header<'_> {
    fn opening(&self) -> String {
        let name = self.name;
        let what = format!(
            "The functions of the module `{name}` in C99 and C++; `{name}_c.rs` is their Rust side, for a static library."
        );
        let lines = ["", &what, ""].into_iter().chain(RULES);
        comment("//", self.facts.origin.lines()) + &comment("//", lines)
    }

    /// What the library that is linked can be compared with.
    fn input(&self) -> String {
        let Self { name, prefix, .. } = self;
        let constant = C_INPUT.to_uppercase();
        let input = self.facts.origin.input_text();
        format!(
            "/// The hash of what this header was generated from. If `{name}_{C_INPUT}()` returns another one, build the library again.\n\
             #define {prefix}{constant} \"{input}\"\n\
             /// The hash of what the library was generated from.\n\
             const char *{name}_{C_INPUT}(void);\n"
        )
    }

    /// Sizes of arrays.
    fn sizes(&self) -> String {
        let define = |size: &Size| {
            let Size {
                name, value, brief, ..
            } = size;
            let note = if self.empty.contains(name.as_str()) {
                " C has no empty arrays: there is none of this length."
            } else {
                ""
            };
            let brief = self.names.renamed(brief, &[]);
            format!(
                "/// {brief}.{note}\n#define {}{name} {value}\n",
                self.prefix
            )
        };
        self.facts.sizes.0.iter().map(define).collect()
    }

    /// Where in their arrays coordinates, speeds, values set at run time, angles, bodies and frames stand.
    fn places(&self) -> Vec<String> {
        let facts = self.facts;
        let bodies = facts.bodies.iter().map(|body| body.identifier.as_str());
        let frames = facts.frames.iter().map(|frame| frame.identifier.as_str());
        let parameters = facts.parameters.iter();
        let parameters = parameters.map(|parameter| parameter.name.as_str());
        let angles = facts.angles.iter().flatten();
        let mut lists = vec![
            Places {
                kind: "BODY",
                doc: "The bodies.".into(),
                names: bodies.collect(),
                notes: Vec::new(),
            },
            Places {
                kind: "FRAME",
                doc: "The frames.".into(),
                names: frames.collect(),
                notes: Vec::new(),
            },
            Places {
                kind: "Q",
                doc: format!(
                    "The coordinates: {COORDINATES} Axes have the lower body's components."
                )
                .into(),
                names: facts.coordinates.iter().map(String::as_str).collect(),
                notes: coordinates(facts),
            },
            Places {
                kind: "U",
                doc: format!("The speeds; {SPEEDS}").into(),
                names: facts.speeds.iter().map(String::as_str).collect(),
                notes: units(&facts.units.speeds),
            },
            Places {
                kind: "PARAMETER",
                doc: "The values set at run time, as columns of derivatives by all of them.".into(),
                names: parameters.collect(),
                notes: Vec::new(),
            },
            Places {
                kind: "ANGLE",
                doc: "The angles among the coordinates, in the order of their sines and cosines."
                    .into(),
                names: angles.map(|angle| angle.name.as_str()).collect(),
                notes: Vec::new(),
            },
        ];
        // An empty enumeration is none in C.
        lists.retain(|list| !list.names.is_empty());
        let mut taken = self.constants();
        let lists = lists.into_iter().map(|list| {
            let Places {
                kind,
                doc,
                names,
                notes,
            } = list;
            let last = names.len() - 1;
            let names = names.into_iter().enumerate();
            let names = names.map(|(place, name)| {
                let name = taken.take(format!("{kind}_{}", name.to_uppercase()));
                let comma = if place < last { "," } else { "" };
                let note = notes.get(place);
                let note = note.map_or_else(String::new, |note| format!(" // {note}"));
                format!("    {}{name} = {place}{comma}{note}\n", self.prefix)
            });
            format!("/// {doc}\nenum {{\n{}}};\n", names.collect::<String>())
        });
        lists.collect()
    }

    /// The names of sizes and tables.
    fn constants(&self) -> Taken {
        let tables = self.facts.all_constants();
        let sizes = self.facts.sizes.0.iter().map(|size| size.name.as_str());
        let tables = tables.iter().map(|constant| constant.name);
        sizes.chain(tables).collect()
    }

    /// What stands in one piece in memory: parameters, what is prepared from them, sines and cosines.
    fn structures(&self) -> Vec<String> {
        let (facts, prefix) = (self.facts, &self.prefix);
        let parameters = facts.parameters.iter();
        let parameters = parameters.map(|parameter| (nominal(parameter), parameter.name.clone()));
        let prepared = (!facts.fields.is_empty()).then(|| {
            let doc = "For the functions alone: their order may change.".to_owned();
            (doc, format!("values[{}]", facts.fields.len()))
        });
        let [of_parameters, of_prepared, of_sines] = C_STRUCTURES;
        let mut structures = vec![
            (
                of_parameters,
                "Values set at run time.",
                parameters.collect(),
            ),
            (
                of_prepared,
                "Whatever depends on parameters alone.",
                Vec::from_iter(prepared),
            ),
        ];
        if let Some(angles) = &facts.angles {
            let fields = ["sines", "cosines"].map(|name| {
                let doc = format!("The {name}: where, `{prefix}ANGLE_...` says.");
                (doc, format!("{name}[{prefix}NA]"))
            });
            let fields = if angles.is_empty() {
                vec![]
            } else {
                fields.to_vec()
            };
            let doc = "The sine and cosine of every angle among the coordinates.";
            structures.push((of_sines, doc, fields));
        }
        let of = |(kind, doc, fields): (&str, &str, Vec<(String, String)>)| {
            SCALARS.map(|scalar| {
                let name = format!("{}_{kind}_{scalar}", self.name);
                structure(&name, doc, &fields, scalar)
            })
        };
        structures.into_iter().flat_map(of).collect()
    }

    /// A function for each scalar.
    fn prototypes(&self, signature: &Signature) -> String {
        let name = |scalar: &str| symbol(self.name, &signature.name, scalar);
        let [double, single] = SCALARS.map(|scalar| {
            let arguments = signature.arguments.iter();
            let arguments: Vec<String> = arguments
                .map(|argument| format!("    {}", self.declared(argument, scalar)))
                .collect();
            format!("void {}(\n{});\n", name(scalar), arguments.join(",\n"))
        });
        let lines = signature
            .lines(|unit| self.facts.units.among(unit))
            .into_iter();
        let arguments = &signature.arguments;
        let doc = comment(
            "///",
            lines.map(|line| self.names.renamed(&line, arguments)),
        );
        format!("{doc}{double}/// As `{}`.\n{single}", name(SCALARS[0]))
    }

    fn declared(&self, argument: &Declared, scalar: &str) -> String {
        let structure = |kind: &str| format!("{}_{kind}_{scalar}", self.name);
        let [of_parameters, of_prepared, of_sines] = C_STRUCTURES;
        let element = match argument.element {
            Element::Scalar => scalar_type(scalar).to_owned(),
            Element::Load => format!("kane_load_{scalar}"),
            Element::Parameters => structure(of_parameters),
            Element::Prepared => structure(of_prepared),
            Element::SinCos => structure(of_sines),
        };
        let constness = match argument.access {
            Access::Read => "const ",
            Access::Written => "",
        };
        let (name, lengths) = (&argument.name, self.lengths(argument));
        match lengths {
            Some(lengths) => format!("{constness}{element} {name}[{lengths}]"),
            None => format!("{constness}{element} *{name}"),
        }
    }

    /// A length by its name in C; none for one that is zero.
    fn constant(&self, name: &str) -> Option<String> {
        (!self.empty.contains(name)).then(|| format!("{}{name}", self.prefix))
    }

    /// The number of elements; none for one, and for an array that is empty, which C does not know.
    fn lengths(&self, argument: &Declared) -> Option<String> {
        let lengths = argument.lengths.iter().map(|length| match length {
            Length::Number(number) => (*number > 0).then(|| number.to_string()),
            Length::Constant(name) => self.constant(name),
            Length::Twice(name) => self.constant(name).map(|name| format!("2 * {name}")),
        });
        let lengths: Vec<String> = lengths.collect::<Option<_>>()?;
        (!lengths.is_empty()).then(|| lengths.join(" * "))
    }
}

/// The structures of loads.
fn loads() -> String {
    let structures = SCALARS.map(|scalar| {
        let fields = [
            (
                "Resultant force at the mass centre of the body with all that is fixed to it, body components, N.",
                "force[3]",
            ),
            (
                "Resultant moment about the mass centre, body components, N m.",
                "moment[3]",
            ),
        ];
        let fields = fields.map(|(doc, field)| (doc.to_owned(), field.to_owned()));
        let name = format!("kane_load_{scalar}");
        structure(&name, "What acts on a body, without its weight.", &fields, scalar)
    });
    structures.join("\n")
}

/// A structure of scalars, each with its documentation. One without fields gets one, for C knows none such.
fn structure(name: &str, doc: &str, fields: &[(String, String)], scalar: &str) -> String {
    let scalar = scalar_type(scalar);
    let field = |(doc, field): &(String, String)| format!("    /// {doc}\n    {scalar} {field};\n");
    let fields = match fields {
        [] => format!("    /// Nothing: C has no empty structures.\n    {scalar} unused;\n"),
        fields => fields.iter().map(field).collect(),
    };
    format!("/// {doc}\ntypedef struct {name} {{\n{fields}}} {name};\n")
}

fn comment<S: AsRef<str>>(mark: &str, lines: impl IntoIterator<Item = S>) -> String {
    let lines = lines.into_iter();
    lines
        .map(|line| format!("{mark} {}", line.as_ref()).trim_end().to_owned() + "\n")
        .collect()
}

/// The units of what an enumeration names.
fn units(units: &[&'static str]) -> Vec<String> {
    let units = units.iter();
    let units = units.map(|unit| if *unit == "1" { "no unit" } else { unit });
    units.map(str::to_owned).collect()
}

/// The units of the coordinates, and about or along which axis they are, where it stays the same.
fn coordinates(facts: &Facts) -> Vec<String> {
    let mut notes = units(&facts.units.coordinates);
    for joint in &facts.joints {
        for (place, coordinate) in joint.q.into_iter().enumerate() {
            let Some((note, axis)) = coordinate.zip(joint.axis(place)) else {
                continue;
            };
            let [x, y, z] = axis.map(|entry| (entry * 1e6).round() / 1e6 + 0.0);
            let word = if place < 4 { "about" } else { "along" };
            notes[note] = format!("{}, {word} ({x}, {y}, {z})", notes[note]);
        }
    }
    notes
}
