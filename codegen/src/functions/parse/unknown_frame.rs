//! What to do about a name that is no frame of the model.

use super::request_error::names;
use crate::{
    diagnostic::{Escaped, NearNames},
    functions::names::dictionary::advice_on_frame,
    tree::{NamedFrame, Tree},
};

/// The most frames that are listed.
const FEW_FRAMES: usize = 8;

/// What was probably meant, or which frames there are; no model has none.
pub(super) fn advice(tree: Option<&Tree>, name: &str, near: &mut NearNames) -> String {
    if let Some(body) = tree.and_then(|tree| jointed_by(tree, name)) {
        return format!("it is the joint of body `{}`; ask for that", body.escaped());
    }
    if let Some(advice) = advice_on_frame(name) {
        return advice;
    }
    let known = tree.map_or_else(Vec::new, |tree| {
        // Tools and feet before bodies.
        let (bodies, others): (Vec<_>, Vec<_>) = tree
            .named_frames()
            .partition(|frame| matches!(frame, NamedFrame::Body(_)));
        let frames = others.into_iter().chain(bodies);
        frames.map(|frame| tree.frame_name(frame)).collect()
    });
    among(&known, name, near)
}

fn among(known: &[&str], name: &str, near: &mut NearNames) -> String {
    let bare = name.trim_matches('\'');
    if bare != name && known.contains(&bare) {
        return "quotes are double, and needed only around names that are not one word".to_owned();
    }
    let count = known.len();
    if count == 0 {
        return "there are none".to_owned();
    }
    let near = near.nearest(name, known.iter().copied());
    if let Some(near) = near.filter(|_| count > FEW_FRAMES) {
        return format!("did you mean `{}`?", near.escaped());
    }
    let mut first: Vec<&str> = known.to_vec();
    // False sorts before true, and what is equal keeps its order.
    first.sort_by_key(|known| (Some(*known) != near, !known.contains(name)));
    if count <= FEW_FRAMES {
        return format!("there are {}", names(&first));
    }
    let some: Vec<&str> = with_a_word_of(name, &first).collect();
    let some = if some.is_empty() { first } else { some };
    let some = names(&some[..some.len().min(FEW_FRAMES)]);
    format!("there are {count}, which `kane info MODEL` lists, such as {some}")
}

/// The body that the joint of this name moves or fixes.
fn jointed_by(tree: &Tree, joint: &str) -> Option<String> {
    let moved = tree.bodies.iter().filter(|body| body.joint.is_named);
    let moved = moved.map(|body| (&body.joint.name, &body.name));
    let fixed = tree.frames.iter();
    let fixed = fixed.filter_map(|frame| Some((frame.joint.as_ref()?, &frame.name)));
    let (_, body) = moved.chain(fixed).find(|(name, _)| *name == joint)?;
    Some(body.clone())
}

/// The names that have a word of another name.
fn with_a_word_of<'k>(name: &str, known: &'k [&'k str]) -> impl Iterator<Item = &'k str> {
    let words = |name: &str| -> Vec<String> {
        let lower = name.to_lowercase();
        let words = lower.split(|letter: char| !letter.is_alphanumeric());
        words
            .filter(|word| word.len() > 1)
            .map(str::to_owned)
            .collect()
    };
    let own = words(name);
    let has_one = move |other: &&str| words(other).iter().any(|word| own.contains(word));
    known.iter().copied().filter(has_one)
}
