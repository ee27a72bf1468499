//! The folder of the runtime crate `kane`, as it is given.

use std::{
    fs,
    path::{Path, PathBuf},
};

use kane_codegen::diagnostic::Escaped;

use crate::cli::Failures;

/// The folder, absolute, if it holds the crate.
pub(crate) fn folder(given: &Path) -> Result<PathBuf, Failures> {
    let absolute = fs::canonicalize(given).ok();
    let absolute = absolute.filter(|folder| folder.join("Cargo.toml").is_file());
    let absolute = absolute.ok_or_else(|| {
        Failures::message(format!(
            "`{}` holds no package; expected the folder of the crate `kane`",
            given.display()
        ))
    })?;
    if let Some(found) = package_of(&absolute).filter(|found| found != "kane") {
        return Err(Failures::message(format!(
            "`{}` holds the package `{}`; expected the folder of the crate `kane`",
            given.display(),
            found.escaped()
        )));
    }
    Ok(absolute)
}

/// The name of the package in a folder, as far as its manifest can be read.
fn package_of(folder: &Path) -> Option<String> {
    let text = fs::read_to_string(folder.join("Cargo.toml")).ok()?;
    let table = ::toml::de::DeTable::parse(&text).ok()?;
    let name = table.get_ref().get("package")?.get_ref().get("name")?;
    name.get_ref().as_str().map(str::to_owned)
}
