//! wip
use kane_codegen::{compile::Options, config::Functions, diagnostic::Source, generate::generate};
fn main() {
    let path = std::env::args().nth(1).unwrap();
    let text = std::fs::read_to_string(&path).unwrap();
    for formulation in [
        kane_codegen::config::Formulation::Notes,
        kane_codegen::config::Formulation::Recursive,
    ] {
        let t = std::time::Instant::now();
        match generate(
            &Source::new(path.clone(), text.clone()),
            &path,
            &Options {
                functions: Functions::All,
                formulation,
            },
        ) {
            Ok(g) => {
                for (n, o) in &g.functions {
                    eprintln!("{n}: {o}");
                }
                eprintln!("{} {:?}", g.warnings, t.elapsed());
                std::fs::write(std::env::args().nth(2).unwrap(), g.source).unwrap();
            }
            Err(e) => eprintln!("{e}"),
        }
    }
}
