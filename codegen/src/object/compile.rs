//! From source to machine code: `rustc`, as a release build calls it, with one codegen unit.
//!
//! The crate `kane` is compiled here too, from its own source, which is the user's: so are the sines that are verified.
//! It needs nothing else without its features, and so nothing is downloaded; a stand-in would have other sines.

use std::{fs, path::Path, process::Command};

use tempfile::TempDir;

use super::{Error, OptLevel, Options, Scalar, roots::Root};

/// The name of the crate around a module, and of the module in it.
pub(super) const MODULE: &str = "generated::module";

/// The crate `kane`, compiled as the modules that need it will be.
#[derive(Debug)]
pub struct Runtime {
    folder: TempDir,
    object: Vec<u8>,
    options: Options,
}

impl Runtime {
    /// Compiles the crate `kane` whose root file this is.
    ///
    /// # Errors
    /// What rustc says, where it does not compile.
    pub fn new(root: &Path, options: &Options) -> Result<Self, Error> {
        let folder = folder_of_its_own()?;
        // Fused multiply-add is there only with this feature.
        let arguments = [
            "--crate-name=kane",
            "--cfg=feature=\"std\"",
            "--emit=metadata,obj",
        ];
        rustc(options, [root, root], folder.path(), &arguments)?;
        Ok(Self {
            object: read(&folder.path().join("kane.o"))?,
            folder,
            options: options.clone(),
        })
    }

    /// The scalar's name.
    pub(super) fn scalar(&self) -> &'static str {
        match self.options.scalar {
            Scalar::F64 => "f64",
            Scalar::F32 => "f32",
        }
    }

    /// The machine code of a module's functions, and that of the runtime.
    pub(super) fn compile(&self, path: &Path, roots: &[Root]) -> Result<[Vec<u8>; 2], Error> {
        let module = fs::canonicalize(path).map_err(io(path))?;
        let Some(module) = module.to_str() else {
            return Err(Error::Path { path: module });
        };
        // Nothing is compiled of a generic function that is not named.
        let names = roots.iter().map(|root| root.path("module", self.scalar()));
        let addresses = names.map(|name| format!("{name} as *const () as usize"));
        let addresses: Vec<String> = addresses.collect();
        let (n_addresses, addresses) = (addresses.len(), addresses.join(", "));
        let text = format!(
            "#![no_std]\n#[path = {module:?}]\npub mod module;\n\
            #[inline(never)]\npub fn functions() -> [usize; {n_addresses}] {{ [{addresses}] }}\n"
        );
        let folder = folder_of_its_own()?;
        let source = folder.path().join("generated.rs");
        fs::write(&source, text).map_err(io(&source))?;
        let runtime = self.folder.path().join("libkane.rmeta");
        let runtime = format!("--extern=kane={}", runtime.display());
        let arguments = ["--crate-name=generated", &runtime, "--emit=obj"];
        rustc(&self.options, [&source, path], folder.path(), &arguments)?;
        Ok([
            read(&folder.path().join("generated.o"))?,
            self.object.clone(),
        ])
    }
}

/// Compiles a library into a folder; in messages the source is known as `shown`.
fn rustc(
    options: &Options,
    [source, shown]: [&Path; 2],
    folder: &Path,
    arguments: &[&str],
) -> Result<(), Error> {
    let level = match options.opt_level {
        OptLevel::Two => "-Copt-level=2",
        OptLevel::Three => "-Copt-level=3",
    };
    let mut command = Command::new("rustc");
    command
        .args(["--edition=2024", "--crate-type=lib", "--cap-lints=allow"])
        .args([level, "-Ccodegen-units=1", "-Csymbol-mangling-version=v0"])
        .arg("--out-dir")
        .arg(folder)
        .args(arguments)
        .arg(source);
    if let Some(cpu) = &options.target_cpu {
        command.arg(format!("-Ctarget-cpu={cpu}"));
    }
    let output = command.output().map_err(Error::NoCompiler)?;
    if output.status.success() {
        return Ok(());
    }
    let said = String::from_utf8_lossy(&output.stderr);
    Err(Error::Refused {
        path: shown.to_owned(),
        message: said.trim_end().to_owned(),
    })
}

fn folder_of_its_own() -> Result<TempDir, Error> {
    tempfile::tempdir().map_err(io(Path::new("a temporary folder")))
}

fn read(path: &Path) -> Result<Vec<u8>, Error> {
    fs::read(path).map_err(io(path))
}

fn io(path: &Path) -> impl FnOnce(std::io::Error) -> Error {
    let path = path.to_owned();
    |source| Error::Io { path, source }
}
