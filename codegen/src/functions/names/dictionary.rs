//! What to say to those who look for a name that we do not have, perhaps another tool's.

use super::{
    ALL, DEFAULT,
    absent::{NO_FUNCTIONS, RUNTIME},
    elsewhere::{OPERATORS, REQUESTS, VARIABLES},
    generated_name, is_set,
};
use crate::{
    diagnostic::{backquoted, nearest},
    functions::{
        function::{Function, Of},
        variable::Variable,
    },
    steps::Step,
};

/// Words with which other tools' names begin.
const BEFORE: [&str; 6] = ["compute", "calc", "get", "eval", "pinocchio", "data"];

/// What names of the mass centre go on with.
const OF_CENTER: [&str; 6] = [
    "",
    "position",
    "velocity",
    "acceleration",
    "jacobian",
    "jacobiandotu",
];

/// Our request for what other tools call so; letters' case and what is no letter or digit do not count.
pub fn elsewhere(name: &str) -> Option<&'static str> {
    let words = words(name);
    let mut own = Function::names().into_iter();
    match own.find(|own| words.contains(&plain(own))) {
        Some(own) => Some(with_frame(own)),
        None => theirs(&words).map(|(request, _)| request),
    }
}

/// Our request for what one of these words means elsewhere, and what to say beside it.
fn theirs(words: &[String]) -> Option<(&'static str, &'static str)> {
    let mut rows = REQUESTS.iter();
    let row = rows.find(|(_, _, names)| is_among(names, words))?;
    Some((row.0, row.1))
}

fn is_among(names: &[&str], words: &[String]) -> bool {
    words.iter().any(|word| names.contains(&word.as_str()))
}

/// Our function, as it is asked for of a frame.
fn with_frame(own: &'static str) -> &'static str {
    let mut requests = REQUESTS.iter().map(|(request, _, _)| *request);
    let of_frame = requests.find(|request| {
        request
            .strip_prefix(own)
            .is_some_and(|rest| rest == "(FRAME)")
    });
    of_frame.unwrap_or(own)
}

/// A name, and what follows the words with which names of other tools begin.
fn words(name: &str) -> Vec<String> {
    let word = with_center_of_mass(&plain(name));
    let rest = BEFORE.iter().filter_map(|before| word.strip_prefix(before));
    let mut words: Vec<String> = rest.map(str::to_owned).collect();
    words.push(word);
    words
}

/// The mass centre in our words, whatever stands behind it: `com_velocity`, `mass_centre_velocity`.
fn with_center_of_mass(word: &str) -> String {
    let word = word.replace("centre", "center");
    let mut rests = ["masscenter", "com"]
        .into_iter()
        .filter_map(|center| word.strip_prefix(center));
    match rests.find(|rest| OF_CENTER.contains(rest)) {
        Some(rest) => format!("centerofmass{rest}"),
        None => word,
    }
}

/// What one of these words stands beside in a table.
fn found(table: &[(&'static str, &[&str])], words: &[String]) -> Option<&'static str> {
    let mut rows = table.iter();
    let row = rows.find(|(_, names)| is_among(names, words));
    row.map(|(own, _)| *own)
}

/// Where the runtime crate has it.
fn of_runtime(name: &str, words: &[String]) -> Option<String> {
    let mut steps = Step::all();
    let step = steps.find(|step| plain(&step.name()) == plain(name));
    let step = step.map(|step| {
        let (rust, c, needs) = (step.of_runtime(), step.name(), step.needs());
        let needs: Vec<&str> = needs.iter().map(String::as_str).collect();
        format!("{rust} in Rust and `{c}` in C, with {}", backquoted(&needs))
    });
    step.or_else(|| found(&RUNTIME, words).map(str::to_owned))
}

fn plain(name: &str) -> String {
    let letters = name.chars().filter(char::is_ascii_alphanumeric);
    letters.map(|letter| letter.to_ascii_lowercase()).collect()
}

/// What to do about a name that is no function.
pub fn advice(name: &str) -> String {
    let words = words(name);
    if let Some(request) = elsewhere(name) {
        let remark = theirs(&words).map_or("", |(_, remark)| remark);
        let comma = if remark.is_empty() { "" } else { ", " };
        format!("here it is called `{request}`{comma}{remark}")
    } else if let Some(operator) = found(&OPERATORS, &words) {
        format!("expected `{operator}`, of a function `F` by variables `X`")
    } else if let Some(of_runtime) = of_runtime(name, &words) {
        format!("that is {of_runtime}")
    } else if let Some(advice) = found(&NO_FUNCTIONS, &words) {
        advice.to_owned()
    } else if let Some(request) = generated_name::request(name) {
        format!("did you mean `{request}`?")
    } else if name == "sin_cos" {
        "a module has it beside functions such as `bias(sin_cos)`".to_owned()
    } else if is_list(name) {
        "`+` joins functions in one; where several may stand, commas are between them".to_owned()
    } else if is_set(name) {
        "it means several functions, and stands alone; for several in one write a sum such as `mass_matrix+bias`"
            .to_owned()
    } else if let Some(near) = nearest(name, &known()).or_else(|| set(name)) {
        format!("did you mean `{near}`?")
    } else if name.contains(['(', '+']) {
        "quotes stand around one name, not around a request".to_owned()
    } else {
        format!(
            "`kane info MODEL --functions all` lists those of a system; those of a frame are {}, and some of its origin alone, as linear_jacobian",
            of_frames().join(", ")
        )
    }
}

/// The names of functions, and that of the default set.
fn known() -> Vec<&'static str> {
    let mut known = Function::names();
    known.push(DEFAULT);
    known
}

/// The word for several functions that differs from this one by letters' case alone.
fn set(name: &str) -> Option<&'static str> {
    [ALL, DEFAULT]
        .into_iter()
        .find(|set| name.eq_ignore_ascii_case(set))
}

/// True for names of functions with spaces between them.
fn is_list(name: &str) -> bool {
    name.contains(' ') && name.split(' ').all(|word| Function::find(word).is_some())
}

/// The names of functions of frames, but for those that leave out what is angular.
fn of_frames() -> Vec<&'static str> {
    let functions = Function::all();
    let functions = functions.filter(|own| !matches!(own.of, Of::System));
    let names = functions.map(|own| own.name);
    names.filter(|own| !own.starts_with("linear_")).collect()
}

/// What to do about a name that is no frame, if it is known to be something else.
pub(in crate::functions) fn advice_on_frame(name: &str) -> Option<String> {
    match &*plain(name) {
        "local" => Some(
            "for the frame's own axes write `local` after the frame: `(FRAME, local)`".to_owned(),
        ),
        "localworldaligned" => Some("vectors are so without any word behind the frame".to_owned()),
        "world" | "universe" | "global" | "inertial" | "ground" => Some(
            "leave it out: what is asked of a frame is relative to the inertial frame".to_owned(),
        ),
        word if with_center_of_mass(word) == "centerofmass" => Some(
            "of the mass centre of all bodies there are `center_of_mass`, `center_of_mass_velocity` and `center_of_mass_jacobian`"
                .to_owned(),
        ),
        _ if Variable::find(None, name).is_some() || Function::find(name).is_some() => {
            Some("derivatives are written `d(F)/d(X)`".to_owned())
        }
        _ => None,
    }
}

/// Our variable for what other tools call so; letters' case and what is no letter or digit do not count.
pub fn variable_elsewhere(name: &str) -> Option<&'static str> {
    found(&VARIABLES, &[plain(name)])
}

/// What to do about a name that is none of these variables.
pub(in crate::functions) fn advice_on_variable(
    function: &str,
    name: &str,
    known: &[String],
) -> String {
    let arguments = Function::find(function).map_or(&[][..], |function| function.arguments);
    let is_given = arguments.iter().any(|argument| argument.name() == name);
    let known: Vec<&str> = known.iter().map(String::as_str).collect();
    let is_list = name.contains(' ') && name.split(' ').all(|word| known.contains(&word));
    if let Some(own) = variable_elsewhere(name) {
        format!("here it is called `{own}`")
    } else if name == "x" {
        "a state is `q, u`".to_owned()
    } else if is_given && ["force", "moment"].contains(&name) {
        "it is linear in these: the factor is `jacobian(FRAME)`, transposed".to_owned()
    } else if is_given && name == "point" {
        "a `[[frame]]` whose `position` is `{ runtime = .. }` is such a point".to_owned()
    } else if is_list {
        "variables stand with commas between them".to_owned()
    } else if let Some(near) = nearest(name, &known) {
        format!("did you mean `{near}`?")
    } else {
        "a number of the model has to be `{ runtime = .. }`".to_owned()
    }
}
