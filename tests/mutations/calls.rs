//! Calls of generated functions: which arguments each has is read in its text.

/// A module with the list of all functions of a text, each as a call in a state that is drawn. The system has parameters that
/// are drawn too.
pub(crate) fn of(text: &str, system: &str) -> String {
    let functions = text.split("\npub fn ").skip(1);
    let signatures = functions.filter_map(|rest| rest.split_once("<R: kane::Real>("));
    let calls: Vec<String> = signatures
        .filter_map(|(name, rest)| Some(call(name, rest.split_once(')')?.0)))
        .collect();
    format!(
        "pub mod calls {{\n\
         use super::*;\n\
         use crate::{{Functions, Numbers, Random}};\n\
         fn system(random: &mut Random) -> Prepared<f64> {{ Prepared::new(&{}) }}\n\
         pub const ALL: Functions = &[{}];\n\
         }}\n",
        parameters(system),
        calls.join(",\n")
    )
}

/// The first argument is the system; the function reads the others, and writes those that it can change.
fn call(name: &str, arguments: &str) -> String {
    let arguments = arguments.split(',').filter(|one| !one.trim().is_empty());
    let kinds = arguments.skip(1).map(|argument| {
        if argument.contains("&mut ") {
            "mut "
        } else {
            ""
        }
    });
    let kinds: Vec<(usize, &str)> = kinds.enumerate().collect();
    let each = |text: &dyn Fn(usize, &str) -> String| -> String {
        let texts = kinds.iter().map(|&(place, kind)| text(place, kind));
        texts.collect::<Vec<_>>().concat()
    };
    let drawn = each(&|place, kind| format!("let {kind}argument_{place} = Numbers::draw(random);"));
    let passed = each(&|place, kind| format!(", &{kind}argument_{place}"));
    let listed = each(&|place, kind| match kind {
        "" => String::new(),
        _ => format!("argument_{place}.list(&mut numbers);"),
    });
    format!(
        "({name:?}, |mut random| {{ let random = &mut random; let mut numbers = Vec::new(); let system = system(random); \
         {drawn} {name}(&system{passed}); {listed} numbers }})"
    )
}

/// Parameters that are drawn, of a module that has some.
fn parameters(module: &str) -> String {
    let fields = module.split_once("pub struct Parameters<R> {");
    let fields = fields.and_then(|(_, rest)| rest.split_once('}'));
    let lines = fields.map_or("", |(fields, _)| fields).lines();
    let names = lines.filter_map(|line| line.trim().strip_prefix("pub ")?.strip_suffix(": R,"));
    let values: Vec<String> = names
        .map(|name| format!("{name}: Numbers::draw(random)"))
        .collect();
    if values.is_empty() {
        "Parameters::default()".to_owned()
    } else {
        format!("Parameters {{ {} }}", values.join(", "))
    }
}
