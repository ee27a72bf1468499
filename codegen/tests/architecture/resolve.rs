//! Which files a path leads to.

use std::collections::BTreeSet;

use crate::krate::Crate;

/// How many times names may be passed on.
const MOST_STEPS: usize = 32;

/// What a path names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Target {
    Module(usize),
    /// Something that this module defines.
    ItemOf(usize),
}

impl Crate {
    /// The files in which it stands what a path names that stands in this module: none for what another crate defines, and
    /// several where a name means several things.
    pub(crate) fn files(&self, module: usize, path: &[String]) -> BTreeSet<String> {
        let targets = self.targets(module, path, MOST_STEPS).into_iter();
        let modules = targets.map(|target| match target {
            Target::Module(module) | Target::ItemOf(module) => module,
        });
        modules
            .map(|module| self.modules[module].file.clone())
            .collect()
    }

    /// What a path names that begins in this module.
    fn targets(&self, module: usize, path: &[String], steps: usize) -> BTreeSet<Target> {
        match path {
            [first, rest @ ..] if first == "crate" => self.below(0, rest, steps),
            [first, rest @ ..] if first == "self" => self.below(module, rest, steps),
            [first, rest @ ..] if first == "super" => {
                let parent = self.modules[module].parent;
                if rest.first().is_some_and(|next| next == "super") {
                    self.targets(parent, rest, steps)
                } else {
                    self.below(parent, rest, steps)
                }
            }
            _ => self.within(module, path, steps),
        }
    }

    /// What a path names whose first name is one of this module's own.
    fn below(&self, module: usize, path: &[String], steps: usize) -> BTreeSet<Target> {
        if path.is_empty() {
            return [Target::Module(module)].into();
        }
        let found = self.within(module, path, steps);
        if found.is_empty() {
            // A macro made it.
            [Target::ItemOf(module)].into()
        } else {
            found
        }
    }

    /// The same, and nothing where the module does not know the name.
    fn within(&self, module: usize, path: &[String], steps: usize) -> BTreeSet<Target> {
        let mut found = BTreeSet::new();
        let ([name, rest @ ..], Some(steps)) = (path, steps.checked_sub(1)) else {
            return found;
        };
        let own = &self.modules[module];
        for (child, place) in &own.children {
            if child == name {
                found.extend(self.below(*place, rest, steps));
            }
        }
        // A function may have the name of a module, but nothing can be below it.
        if !found.is_empty() && !rest.is_empty() {
            return found;
        }
        if own.defined.contains(name) {
            found.insert(Target::ItemOf(module));
        }
        for one in &own.uses {
            let is_named = one.name.as_ref().is_some_and(|known| known == name);
            // A path that is in scope by its own first name, such as `use toml::read` beside `mod toml`.
            if is_named && one.path != path[..1] {
                for target in self.targets(module, &one.path, steps) {
                    match target {
                        Target::Module(passed) => found.extend(self.below(passed, rest, steps)),
                        Target::ItemOf(_) => drop(found.insert(target)),
                    }
                }
            } else if one.name.is_none() {
                for target in self.targets(module, &one.path, steps) {
                    if let Target::Module(passed) = target {
                        found.extend(self.within(passed, path, steps));
                    }
                }
            }
        }
        found
    }
}
