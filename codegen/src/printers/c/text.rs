//! Pieces of a header.

/// What several headers declare, and a program that includes them once.
pub(super) fn once(guard: &str, text: &str) -> String {
    format!("#ifndef {guard}\n#define {guard}\n{text}#endif\n")
}

/// A constant table, an entry a line.
pub(super) fn table(doc: &str, declared: &str, entries: impl Iterator<Item = String>) -> String {
    let entries: Vec<String> = entries.map(|entry| format!("    {entry}")).collect();
    let entries = entries.join(",\n");
    format!("/// {doc}\nstatic const {declared} = {{\n{entries}\n}};\n")
}
