//! Files that xacro did not expand: links, joints and parts of them may be missing.

use crate::description::urdf::named::IGNORED;
use crate::description::xml::Element;
use crate::diagnostic::{Diagnostic, Source, shown};

/// Elements of xacro that stand for nothing: what is left of them in a URDF does no harm, if nothing is to be computed.
const LEFTOVERS: [&str; 3] = ["xacro:arg", "xacro:macro", "xacro:property"];

/// What old files call `xacro:insert_block`.
const BLOCK: &str = "insert_block";

/// What is wrong with a file that xacro did not expand.
pub(super) fn unexpanded(robot: Element<'_>, source: &Source) -> Option<Diagnostic> {
    let computes = source.text().contains("${");
    let mut open = vec![robot];
    while let Some(next) = open.pop() {
        let mut children = next.children();
        let first = children.find(|child| stands_for_more(*child, next, computes));
        if let Some(first) = first {
            let fault = format!("`{}` is no element of a URDF", shown(first.name()));
            let fault = Diagnostic::error(fault).at(first.span(), "an element of xacro");
            return Some(fault.help("expand the file first: `xacro robot.xacro >robot.urdf`"));
        }
        let mut inside: Vec<Element<'_>> = next.children().filter(counts).collect();
        inside.reverse();
        open.append(&mut inside);
    }
    None
}

/// True for an element in whose place xacro would put others.
fn stands_for_more(element: Element<'_>, around: Element<'_>, computes: bool) -> bool {
    let name = element.name();
    // An origin beside it is what it would have become.
    let is_missing = name == BLOCK && around.children_named("origin").next().is_none();
    is_missing || name.starts_with("xacro:") && (computes || !LEFTOVERS.contains(&name))
}

/// True for what is read. The text of a macro stands for nothing.
fn counts(element: &Element<'_>) -> bool {
    let name = element.name();
    !IGNORED.contains(&name) && !name.starts_with("xacro:")
}
