//! Values of arguments, read and written.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use kane_codegen::options::SNAP_TOLERANCES;

/// Reads the name of one of these choices.
pub(crate) fn one_of<T: Clone + Send + Sync + 'static, const N: usize>(
    choices: [(&'static str, T); N],
) -> impl TypedValueParser<Value = T> {
    let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
    PossibleValuesParser::new(names).map(move |name| {
        let found = choices.iter().find(|(known, _)| *known == name);
        found.expect("clap takes only these names").1.clone()
    })
}

/// Reads a tolerance.
pub(crate) fn tolerance(text: &str) -> Result<f64, String> {
    let tolerance: f64 = text.parse().map_err(|_| "expected a number".to_owned())?;
    if SNAP_TOLERANCES.contains(&tolerance) {
        Ok(tolerance + 0.0)
    } else {
        let (least, end) = (SNAP_TOLERANCES.start, SNAP_TOLERANCES.end);
        Err(format!("expected at least {least} and less than {end}"))
    }
}

/// Reads `NAME` or `NAME=VALUE`.
pub(crate) fn lock(text: &str) -> Result<(String, f64), String> {
    let (name, value) = text.rsplit_once('=').unwrap_or((text, "0"));
    let value: f64 = value
        .parse()
        .map_err(|_| format!("`{value}` is no number"))?;
    if name.is_empty() {
        Err("expected a name before the value".to_owned())
    } else if value.is_finite() {
        Ok((name.to_owned(), value + 0.0))
    } else {
        Err("expected a finite number".to_owned())
    }
}

/// The text as a shell reads it back.
pub(crate) fn quoted(text: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "_-./,=:@+%".contains(c);
    if !text.is_empty() && text.chars().all(plain) {
        text.to_owned()
    } else {
        format!("'{}'", text.replace('\'', r"'\''"))
    }
}
