//! Walking TOML values by hand, so that every fault of a file is found, not only the first.
//!
//! In: spanned values. Out: checked values, `None` where there is none; the faults gather in the [`Reader`].

use ::toml::Spanned as TomlSpanned;
use ::toml::de::{DeTable, DeValue};

use crate::description::{elsewhere, too_many};
use crate::diagnostic::{
    Diagnostic, Escaped, Faults, Severity, Source, Span, Spanned, backquoted, nearest,
};
use crate::limits::TOLD;

/// A TOML value with its place.
pub(crate) type Item<'s> = TomlSpanned<DeValue<'s>>;

/// Reads values and keeps what is wrong with them.
#[derive(Debug, Default)]
pub(crate) struct Reader {
    pub(crate) faults: Faults,
}

/// A table, with the words for it in messages.
#[derive(Debug)]
pub(crate) struct Table<'t, 's> {
    keys: &'t DeTable<'s>,
    /// The place of the table's beginning; `None` for a whole file.
    span: Option<Span>,
    /// Such as "body `hub`"; empty for a whole file.
    owner: String,
    /// Known keys that an unknown one was probably meant to be: that they are missing would be the same fault again.
    misspelt: Vec<String>,
}

impl<'t, 's> Table<'t, 's> {
    /// The value of a key that may be absent.
    pub(crate) fn get(&self, key: &str) -> Option<&'t Item<'s>> {
        self.keys.get(key)
    }

    /// The key's own place and its value, for every key.
    pub(crate) fn entries(
        &self,
    ) -> impl Iterator<Item = (Spanned<&'t str>, &'t Item<'s>)> + use<'t, 's> {
        self.keys
            .iter()
            .map(|(key, value)| (Spanned::new(key.get_ref().as_ref(), key.span()), value))
    }

    /// True where an unknown key was probably meant to be this one.
    pub(crate) fn is_misspelt(&self, key: &str) -> bool {
        self.misspelt.iter().any(|misspelt| misspelt == key)
    }

    /// The words for the value of a key: "`mass` of body `hub`".
    pub(crate) fn what(&self, key: &str) -> String {
        if self.owner.is_empty() {
            format!("`{key}`")
        } else {
            format!("`{key}` of {}", self.owner)
        }
    }
}

/// Where the table ends that a key names, if the key stands in brackets at the beginning of a line.
fn table_end(text: &str, key: Span) -> Option<usize> {
    let is_headed = text.get(..key.start)?.ends_with("\n[") || text.get(..key.start)? == "[";
    let rest = text.get(key.end..)?;
    is_headed.then(|| {
        rest.find("\n[")
            .map_or(text.len(), |line| key.end + line + 1)
    })
}

/// The place of a value.
pub(crate) fn span(item: &Item<'_>) -> Span {
    item.span().into()
}

impl Reader {
    /// The whole file as a table; empty, with the faults kept, where it is not TOML.
    ///
    /// Values are recovered only where the sole syntax faults are repeated keys: after others, guesses would
    /// lead to faults that are not there.
    pub(crate) fn document<'s>(&mut self, source: &'s Source) -> DeTable<'s> {
        let (table, errors) = DeTable::parse_recoverable(source.text());
        let is_repeated = |error: &::toml::de::Error| error.message() == "duplicate key";
        let recovered = errors.iter().all(is_repeated);
        let lines = filled_lines(source.text());
        let mut last_line = None;
        // Up to where all is in a table that was there before.
        let mut repeated_to = 0;
        for error in errors.iter().take(TOLD) {
            let end = source.text().len();
            let span = Span::from(error.span().unwrap_or(end..end));
            if is_repeated(error) {
                if span.start < repeated_to {
                    continue;
                }
                let key = source.text().get(span.start..span.end).unwrap_or_default();
                let message = format!("the key `{}` is given twice", key.escaped());
                let fault = Diagnostic::error(message).at(span, "the second one");
                self.faults.push(match table_end(source.text(), span) {
                    Some(end) => {
                        repeated_to = end;
                        fault.help(format!(
                            "several tables are written `[[{}]]`",
                            key.escaped()
                        ))
                    }
                    None => fault,
                });
                continue;
            }
            // After an open bracket every line is a fault; the first of adjacent lines is the one to mend.
            let line = lines.partition_point(|start| *start <= span.start);
            let follows = last_line.is_some_and(|last| line <= last + 1);
            last_line = last_line.max(Some(line));
            if !follows {
                let message = format!("not valid TOML: {}", error.message());
                let fault = Diagnostic::error(message).at(span, "here");
                self.faults.push(if has_unit(source.text(), span) {
                    fault.help(
                        "write numbers without units; they are in m, kg, kg m^2, rad, s, N and N m",
                    )
                } else {
                    fault
                });
            }
        }
        if recovered {
            table.into_inner()
        } else {
            DeTable::new()
        }
    }

    /// True if something was wrong with the file, so that an absent key may be there.
    pub(crate) fn has_faults(&self) -> bool {
        self.faults.count() > 0
    }

    /// The whole file, with the keys that it may have.
    pub(crate) fn root<'t, 's>(&mut self, keys: &'t DeTable<'s>, known: &[&str]) -> Table<'t, 's> {
        let mut table = Table {
            keys,
            span: None,
            owner: String::new(),
            misspelt: Vec::new(),
        };
        self.unknown_keys(&mut table, known);
        table
    }

    /// A value that must be a table, with the keys that it may have; `owner` is the words for it.
    pub(crate) fn table<'t, 's>(
        &mut self,
        item: &'t Item<'s>,
        owner: &str,
        known: &[&str],
    ) -> Option<Table<'t, 's>> {
        let mut table = self.any_table(item, owner)?;
        self.unknown_keys(&mut table, known);
        Some(table)
    }

    /// The same; `example` is one that would do.
    pub(crate) fn table_such_as<'t, 's>(
        &mut self,
        item: &'t Item<'s>,
        owner: &str,
        known: &[&str],
        example: &str,
    ) -> Option<Table<'t, 's>> {
        if item.get_ref().is_table() {
            return self.table(item, owner, known);
        }
        let fault = mistyped(item, owner, "a table");
        self.faults
            .push(fault.help(format!("write for example `{example}`")));
        None
    }

    /// A value that must be a table, with any keys.
    pub(crate) fn any_table<'t, 's>(
        &mut self,
        item: &'t Item<'s>,
        owner: &str,
    ) -> Option<Table<'t, 's>> {
        let DeValue::Table(keys) = item.get_ref() else {
            self.wrong_type(item, owner, "a table");
            return None;
        };
        Some(Table {
            keys,
            span: Some(span(item)),
            owner: owner.to_owned(),
            misspelt: Vec::new(),
        })
    }

    fn unknown_keys(&mut self, table: &mut Table<'_, '_>, known: &[&str]) {
        let entries = table.entries();
        for (key, _) in entries.filter(|(key, _)| !known.contains(&key.value)) {
            if self.faults.is_full(Severity::Error) {
                return;
            }
            let of = if table.owner.is_empty() {
                String::new()
            } else {
                format!(" of {}", table.owner)
            };
            let message = format!("unknown key `{}`{of}", key.value.escaped());
            let absent: Vec<&str> = known
                .iter()
                .copied()
                .filter(|known| table.get(known).is_none())
                .collect();
            let meant = elsewhere::key(key.value, &absent);
            let meant = meant.or_else(|| nearest(key.value, &absent));
            let help = match (meant, elsewhere::place(key.value)) {
                (Some(known), _) => {
                    table.misspelt.push(known.to_owned());
                    format!("did you mean `{known}`?")
                }
                (None, Some(place)) => place.to_owned(),
                (None, None) if known.len() == 1 => {
                    format!("the only key here is {}", backquoted(known))
                }
                (None, None) => format!("the keys here are {}", backquoted(known)),
            };
            self.faults.push(
                Diagnostic::error(message)
                    .at(key.span, "unknown key")
                    .help(help),
            );
        }
    }

    /// The value of a key that must be there; `example` is a line that would do.
    pub(crate) fn required<'t, 's>(
        &mut self,
        table: &Table<'t, 's>,
        key: &str,
        example: &str,
    ) -> Option<&'t Item<'s>> {
        let item = table.get(key);
        if item.is_none() && !table.is_misspelt(key) {
            let fault = match table.span {
                Some(span) => Diagnostic::error(format!("{} has no `{key}`", table.owner))
                    .at(span, format!("`{key}` is missing")),
                None => Diagnostic::error(format!("the file has no `{key}`")),
            };
            self.faults
                .push(fault.help(format!("write for example `{example}`")));
        }
        item
    }

    /// Reports which of these keys are not there, all in one; `help` is what to do.
    pub(crate) fn complete(&mut self, table: &Table<'_, '_>, keys: &[&str], help: &str) {
        let is_missing = |key: &&str| table.get(key).is_none() && !table.is_misspelt(key);
        let missing: Vec<&str> = keys.iter().copied().filter(is_missing).collect();
        if let (false, Some(span)) = (missing.is_empty(), table.span) {
            let message = format!("{} lacks {}", table.owner, backquoted(&missing));
            let fault = Diagnostic::error(message).at(span, "incomplete");
            self.faults.push(fault.help(help));
        }
    }

    /// A value that must be a string.
    pub(crate) fn string(&mut self, item: &Item<'_>, what: &str) -> Option<Spanned<String>> {
        if let DeValue::String(text) = item.get_ref() {
            return Some(Spanned::new(text.to_string(), item.span()));
        }
        self.wrong_type(item, what, "a string");
        None
    }

    /// A string that must be the name of one of the choices; `label` stands below one that is not.
    pub(crate) fn choice<T: Copy>(
        &mut self,
        item: &Item<'_>,
        what: &str,
        choices: &[(&str, T)],
        label: &str,
    ) -> Option<Spanned<T>> {
        self.choice_or_help(item, what, choices, label, None)
    }

    /// The same, with what helps where it is none.
    pub(crate) fn choice_or_help<T: Copy>(
        &mut self,
        item: &Item<'_>,
        what: &str,
        choices: &[(&str, T)],
        label: &str,
        help: Option<&str>,
    ) -> Option<Spanned<T>> {
        let text = self.string(item, what)?;
        let found = choices.iter().find(|(name, _)| *name == text.value);
        if found.is_none() {
            let names: Vec<String> = choices
                .iter()
                .map(|(name, _)| format!("`{name}`"))
                .collect();
            let expected = match names.split_last() {
                Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
                _ => names.concat(),
            };
            let found = text.value.escaped();
            let fault = Diagnostic::error(format!("{what} is `{found}`; expected {expected}"));
            self.faults.push(fault.at(text.span, label).help_if(help));
        }
        found.map(|(_, value)| Spanned::new(*value, text.span))
    }

    /// A value that must be a list.
    pub(crate) fn list<'t, 's>(
        &mut self,
        item: &'t Item<'s>,
        what: &str,
        of: &str,
    ) -> Option<Vec<&'t Item<'s>>> {
        if let DeValue::Array(entries) = item.get_ref() {
            if let Some(fault) = too_many(
                &format!("the number of entries of {what} is"),
                entries.len(),
            ) {
                self.faults.push(fault.at(span(item), "too many"));
                return None;
            }
            return Some(entries.iter().collect());
        }
        self.wrong_type(item, what, &format!("a list of {of}"));
        None
    }

    /// A value that must be a whole number.
    pub(crate) fn integer(&mut self, item: &Item<'_>, what: &str) -> Option<Spanned<i64>> {
        let DeValue::Integer(digits) = item.get_ref() else {
            self.wrong_type(item, what, "a whole number");
            return None;
        };
        let number = i64::from_str_radix(digits.as_str(), digits.radix()).ok();
        if number.is_none() {
            self.out_of_range(item, what, digits.as_str(), "a 64-bit integer");
        }
        number.map(|number| Spanned::new(number, item.span()))
    }

    /// A value that must be a finite number; minus zero becomes zero.
    pub(crate) fn number(&mut self, item: &Item<'_>, what: &str) -> Option<Spanned<f64>> {
        let number = match item.get_ref() {
            DeValue::Integer(_) => self.integer(item, what)?.value as f64,
            DeValue::Float(digits) => {
                let number: f64 = digits.as_str().parse().unwrap_or(f64::NAN);
                if number.is_infinite() && !digits.as_str().contains("inf") {
                    self.out_of_range(item, what, digits.as_str(), "a 64-bit float");
                    return None;
                }
                number
            }
            _ => {
                self.wrong_type(item, what, "a number");
                return None;
            }
        };
        if !number.is_finite() {
            let message = format!(
                "{what} is {}; expected a finite number",
                if number.is_nan() { "nan" } else { "infinite" }
            );
            self.faults
                .push(Diagnostic::error(message).at(span(item), "not finite"));
            return None;
        }
        // So that `-0.0` and `0` are the same description.
        Some(Spanned::new(number + 0.0, item.span()))
    }

    /// A value that must be true or false.
    pub(crate) fn truth(&mut self, item: &Item<'_>, what: &str) -> Option<bool> {
        if let DeValue::Boolean(value) = item.get_ref() {
            return Some(*value);
        }
        self.wrong_type(item, what, "true or false");
        None
    }

    fn out_of_range(&mut self, item: &Item<'_>, what: &str, digits: &str, kind: &str) {
        let shown: String = if digits.len() > 24 {
            format!("{}...", &digits[..24])
        } else {
            digits.to_owned()
        };
        let message = format!("{what} is {shown}, which does not fit {kind}");
        self.faults
            .push(Diagnostic::error(message).at(span(item), "too large"));
    }

    pub(crate) fn wrong_type(&mut self, item: &Item<'_>, what: &str, expected: &str) {
        self.faults.push(mistyped(item, what, expected));
    }
}

fn mistyped(item: &Item<'_>, what: &str, expected: &str) -> Diagnostic {
    let found = match item.get_ref() {
        DeValue::String(_) => "a string",
        DeValue::Integer(_) => "a whole number",
        DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "a truth value",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    };
    let fault = Diagnostic::error(format!("{what} is {found}; expected {expected}"));
    fault
        .at(span(item), format!("expected {expected}"))
        .help_if(elsewhere::value(what))
}

/// True where letters follow a number, as a unit would.
fn has_unit(text: &str, span: Span) -> bool {
    let of_number = |c: char| c.is_ascii_digit() || c == '.';
    let before = text.get(..span.start).unwrap_or_default();
    let found = text.get(span.start..).unwrap_or_default();
    let after = found.trim_start_matches(of_number);
    (before.ends_with(of_number) || after.len() < found.len())
        && after
            .trim_start_matches(' ')
            .starts_with(char::is_alphabetic)
}

/// Where the lines start that are neither empty nor a comment.
fn filled_lines(text: &str) -> Vec<usize> {
    let mut start = 0;
    let mut starts = Vec::new();
    for line in text.split_inclusive('\n') {
        if !line.trim().is_empty() && !line.trim_start().starts_with('#') {
            starts.push(start);
        }
        start += line.len();
    }
    starts
}
