//! Which name was meant by one that is unknown.

/// Bytes of the longest word for which one that is near is looked for.
const LONGEST: usize = 100;

/// Letters of the shortest word that tells with which name it begins.
const SHORTEST: usize = 3;

/// What is compared for all words of a list together: letters of a word times letters of a candidate.
const MOST_COMPARED: usize = 20_000_000;

/// Looks for names that are near until that has taken too long: a list may have thousands of unknown names.
#[derive(Debug)]
pub struct NearNames {
    n_left: usize,
}

impl Default for NearNames {
    fn default() -> Self {
        Self {
            n_left: MOST_COMPARED,
        }
    }
}

impl NearNames {
    /// The [`nearest`]; `None` from where that takes too long.
    pub fn nearest<'a>(
        &mut self,
        word: &str,
        candidates: impl IntoIterator<Item = &'a str>,
    ) -> Option<&'a str> {
        let mut found = Vec::new();
        for candidate in candidates {
            // What is too long to be compared costs as much as the longest that is: collecting it takes time too.
            let cost = (word.len().min(LONGEST) + 1) * (candidate.len().min(2 * LONGEST) + 1);
            let Some(n_left) = self.n_left.checked_sub(cost) else {
                self.n_left = 0;
                return None;
            };
            self.n_left = n_left;
            found.push(candidate);
        }
        nearest(word, &found)
    }
}

/// The candidate that `word` was probably meant to be: one that is near enough, or the only one that begins so.
pub fn nearest<'a>(word: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let lower = word.to_lowercase();
    // A very long word is near nothing, and the distance costs the product of both lengths.
    if lower.len() > LONGEST {
        return None;
    }
    let letters: Vec<char> = lower.chars().collect();
    let mut near: Option<(usize, &str)> = None;
    for candidate in candidates.iter().filter(|own| own.len() <= 2 * LONGEST) {
        let other: Vec<char> = candidate.to_lowercase().chars().collect();
        let most = other.len() / 3;
        if letters.len().abs_diff(other.len()) > most {
            continue;
        }
        let edits = edits(&letters, &other);
        if edits <= most && near.is_none_or(|(least, _)| edits < least) {
            near = Some((edits, candidate));
        }
    }
    let near = near.map(|(_, candidate)| candidate);
    near.or_else(|| begun(&lower, candidates))
}

/// The one candidate that begins so.
fn begun<'a>(word: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let is_begun = |candidate: &&&str| candidate.to_lowercase().starts_with(word);
    let mut begun = candidates.iter().filter(is_begun);
    let only = begun.next().filter(|_| begun.next().is_none());
    only.filter(|_| word.chars().count() >= SHORTEST).copied()
}

/// Insertions, deletions, replacements and swaps of neighbours that lead from one word to the other.
fn edits(from: &[char], to: &[char]) -> usize {
    let width = to.len() + 1;
    let at = |i: usize, j: usize| i * width + j;
    let mut table: Vec<usize> = (0..width).collect();
    table.resize((from.len() + 1) * width, 0);
    for i in 1..=from.len() {
        table[at(i, 0)] = i;
        for j in 1..=to.len() {
            let replaced = table[at(i - 1, j - 1)] + usize::from(from[i - 1] != to[j - 1]);
            let mut least = replaced
                .min(table[at(i - 1, j)] + 1)
                .min(table[at(i, j - 1)] + 1);
            if i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1] {
                least = least.min(table[at(i - 2, j - 2)] + 1);
            }
            table[at(i, j)] = least;
        }
    }
    table[at(from.len(), to.len())]
}
