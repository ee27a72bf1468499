//! Paths as models write them, on whatever system.

/// The name of a file without folders.
pub(in crate::description::mjcf) fn file_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

/// True for a path that does not start from a model's folder.
pub(in crate::description::mjcf) fn is_absolute(path: &str) -> bool {
    path.starts_with(['/', '\\']) || path.contains(":/") || path.contains(":\\")
}
