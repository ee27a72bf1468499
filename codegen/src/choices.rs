//! Tables of choices, each with its name.

/// The name of one of these choices.
pub fn name_of<T: PartialEq>(value: &T, choices: &[(&'static str, T)]) -> &'static str {
    let found = choices.iter().find(|(_, choice)| choice == value);
    found.expect("choices: each has a name").0
}
