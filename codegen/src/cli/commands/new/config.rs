//! The `kane.toml` of a new package.

use kane_codegen::{
    choices::name_of,
    companions::Abi,
    description::{Base, Chart, Reading, toml::quoted},
    functions::{DEFAULT, parse::syntax::written},
    id::BodyId,
    options::{Functions, Options},
    tree::{Changes, Tree},
};

/// One system: the model, read and changed by these options, that becomes the module `name`.
pub(super) fn config(
    name: &str,
    model: &str,
    tree: &Tree,
    options: &Options,
    abi: Option<Abi>,
) -> String {
    let Reading {
        base,
        chart,
        leave_out,
    } = &options.reading;
    let base = base.map(|base| format!("base = \"{}\"\n", name_of(&base, &Base::NAMED)));
    let chart = chart.map(|chart| format!("chart = \"{}\"\n", name_of(&chart, &Chart::NAMED)));
    let leave_out = list(
        Reading::LEAVE_OUT,
        leave_out.iter().map(|name| quoted(name)),
    );
    let abi = abi.map(|abi| format!("abi = \"{}\"\n", name_of(&abi, &Abi::ALL)));
    // Tools and feet are at the ends, and what is fixed there. A model that is generated moves something.
    let is_end = |body: &BodyId| tree.uppers(*body).is_empty();
    let bodies = tree.body_ids().filter(is_end);
    let bodies = bodies.map(|body| tree.body(body).name.as_str());
    let frames = tree.frames.iter().chain(&tree.markers);
    let frames = frames.filter(|frame| frame.body.as_ref().is_some_and(is_end));
    let frames = frames.map(|frame| frame.name.as_str());
    let last = bodies.chain(frames).last().unwrap_or_default();
    let jacobian = quoted(&format!("jacobian({})", written(last)));
    let changes = changes(options);
    let more = [base, chart, leave_out]
        .into_iter()
        .chain(changes)
        .chain([abi]);
    let more = more.flatten();
    let functions = match &options.functions {
        Functions::Default(more) if !more.is_empty() => {
            let all = std::iter::once(DEFAULT).chain(more.iter().map(String::as_str));
            let all: Vec<String> = all.map(quoted).collect();
            format!("functions = [{}]\n", all.join(", "))
        }
        _ => format!("# functions = [\"default\", {jacobian}]   # the default set and more\n"),
    };
    format!(
        "[[system]]\nmodel = {}\noutput = \"src/{name}.rs\"\n{}tests = true\n{functions}",
        quoted(model),
        more.collect::<String>()
    )
}

/// What is changed of the model, a line a key.
fn changes(options: &Options) -> [Option<String>; 5] {
    let Changes {
        snap,
        lock,
        remove,
        remove_massless,
    } = &options.changes;
    let is_changed = *snap != Changes::default().snap;
    let locked = lock.iter();
    let locked = locked.map(|(name, value)| format!("{} = {value:?}", quoted(name)));
    let locked: Vec<String> = locked.collect();
    [
        is_changed.then(|| format!("snap = {snap:?}\n")),
        (!locked.is_empty()).then(|| format!("lock = {{ {} }}\n", locked.join(", "))),
        list(Changes::REMOVE, remove.iter().map(|name| quoted(name))),
        remove_massless.then(|| "remove_massless = true\n".to_owned()),
        list(
            "prescribed",
            options.prescribed.iter().map(|name| quoted(name)),
        ),
    ]
}

/// A key with a list, where that holds anything.
fn list(key: &str, names: impl Iterator<Item = String>) -> Option<String> {
    let names: Vec<String> = names.collect();
    (!names.is_empty()).then(|| format!("{key} = [{}]\n", names.join(", ")))
}
