//! Modules with one token changed.

/// What a token becomes: a sign, or another operation.
const CHANGES: [(&str, &str); 4] = [
    (" + ", " - "),
    (" - ", " + "),
    (" * ", " + "),
    ("= -", "= "),
];

/// A module that is wrong in one place.
#[derive(Clone, Debug)]
pub struct Mutant {
    pub module: String,
    /// The line that is wrong.
    pub line: String,
    /// Where in the module its token begins.
    pub place: usize,
}

impl Mutant {
    /// The function that is wrong, alone: its name, and its text after that of its helpers.
    pub fn function(&self) -> (&str, String) {
        let own = functions(&self.module);
        let wrong = own.iter().rev().find(|own| own.start <= self.place);
        let wrong = wrong.map_or("", |own| own.of);
        let parts = own.iter().filter(|own| own.of == wrong);
        (wrong, parts.map(|own| own.text).collect())
    }
}

/// A function of a module, or a helper of one.
struct Item<'a> {
    /// Where it begins.
    start: usize,
    /// The name of the function; of a helper, that of the function that calls it.
    of: &'a str,
    text: &'a str,
}

/// All functions of a module that stand by themselves.
fn functions(module: &str) -> Vec<Item<'_>> {
    const END: &str = "\n}\n";
    let public = module.match_indices("\npub fn ");
    let helpers = module.match_indices("\nfn ");
    let mut items: Vec<Item<'_>> = public
        .chain(helpers)
        .map(|(start, beginning)| {
            let rest = &module[start..];
            let end = rest.find(END).map_or(rest.len(), |end| end + END.len());
            let name = rest[beginning.len()..]
                .split('<')
                .next()
                .unwrap_or_default();
            Item {
                start,
                of: name.split("_lockstep_").next().unwrap_or(name),
                text: &rest[..end],
            }
        })
        .collect();
    items.sort_by_key(|item| item.start);
    items
}

/// The module with one token of one function changed.
pub fn mutant(module: &str, seed: u64) -> Mutant {
    let start = module.find("pub fn ").unwrap_or(0);
    let places: Vec<(usize, &str, &str)> = CHANGES
        .iter()
        .flat_map(|&(from, to)| {
            let found = module.match_indices(from);
            found.map(move |(place, _)| (place, from, to))
        })
        .filter(|&(place, ..)| place > start && is_statement(line_at(module, place)))
        .collect();
    let chosen = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 33;
    let chosen = usize::try_from(chosen).unwrap_or(0) % places.len();
    let (place, from, to) = places[chosen];
    let mut text = module.to_owned();
    text.replace_range(place..place + from.len(), to);
    let line = line_at(&text, place).trim().to_owned();
    Mutant {
        module: text,
        line,
        place,
    }
}

fn line_at(text: &str, place: usize) -> &str {
    let start = text[..place].rfind('\n').map_or(0, |end| end + 1);
    let end = text[place..]
        .find('\n')
        .map_or(text.len(), |end| place + end);
    &text[start..end]
}

/// True for a line of a function's body: no comment, and no text of a table between functions.
fn is_statement(line: &str) -> bool {
    let begins = |sign: &str| line.trim_start().starts_with(sign);
    line.starts_with("    ") && !begins("//") && !begins("\"") && !has_crumb(line)
}

/// True for a line with what rounding leaves of a cosine that is zero, `2^-57`: its sign changes no digit of what it is added to.
fn has_crumb(line: &str) -> bool {
    /// The least part of one that cosines of a few roundings are multiples of.
    const PART: f64 = f64::EPSILON / 64.0;
    let numbers = line.split("from_f64(").skip(1);
    let numbers = numbers.filter_map(|rest| rest.split(')').next()?.parse::<f64>().ok());
    let mut sizes = numbers.map(f64::abs);
    sizes.any(|size| size > 0.0 && size < 4.0 * f64::EPSILON && (size / PART).fract() == 0.0)
}
