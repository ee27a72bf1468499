//! What callers in C have to know, in whatever language the functions are written.

/// The scalars of C, as Rust names them.
pub(crate) const SCALARS: [&str; 2] = ["f64", "f32"];

/// The scalar in C.
pub(crate) fn scalar_type(scalar: &str) -> &'static str {
    if scalar == "f64" { "double" } else { "float" }
}

/// The name by which C calls a function of this module.
pub(crate) fn symbol(module: &str, function: &str, scalar: &str) -> String {
    format!("{module}_{function}_{scalar}")
}

/// What callers have to keep to.
pub(crate) const RULES: [&str; 10] = [
    "No function allocates, keeps state, fails, or checks what it is given. Several threads may call them at once, with the same",
    "prepared parameters too. Matrices are row after row, and what bodies have is body after body. Units are kg, m, s, rad and N.",
    "A matrix is one array, `double m[N * N]`; of two dimensions it is passed as `(double *)m`.",
    "Numbers of equations are those of `docs/equations.md` in the repository of `kane`.",
    "",
    "The behaviour is undefined where",
    "- a pointer is null, not aligned as its type is, or leads to fewer elements than are declared;",
    "- something is read that holds no value yet, or prepared parameters that `prepare` did not write for the same scalar;",
    "- something is written to which another argument leads as well, unless the function allows it.",
    "What is only read may overlap, and what is written may hold anything before.",
];
