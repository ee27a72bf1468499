//! What no description can make right: options that cannot be.

use std::collections::BTreeSet;

use crate::{
    error::Error,
    functions::{Parsed, RequestError},
    options::{Options, SNAP_TOLERANCES, companion},
};

/// Refuses options that cannot be.
pub(crate) fn check(options: &Options) -> Result<(), Error> {
    let tolerance = options.changes.snap;
    if !SNAP_TOLERANCES.contains(&tolerance) {
        return Err(Error::SnapTolerance { tolerance });
    }
    let mut locked = options.changes.lock.iter();
    if let Some((name, value)) = locked.find(|(_, value)| !value.is_finite()) {
        return Err(Error::LockedValue {
            name: name.clone(),
            value: *value,
        });
    }
    let mut known = BTreeSet::new();
    let mut names = options.changes.lock.iter().map(|(name, _)| name);
    if let Some(name) = names.find(|name| !known.insert(*name)) {
        return Err(Error::LockedTwice { name: name.clone() });
    }
    if !companion::can_be_beside(&options.companions, &options.module) {
        return Err(Error::ModuleName {
            name: options.module.clone(),
        });
    }
    let names = options.functions.named().iter();
    let faults = names.filter_map(|name| Parsed::read(name).err()).flatten();
    let faults: Vec<RequestError> = faults.collect();
    if faults.is_empty() {
        Ok(())
    } else {
        Err(Error::Requests(faults))
    }
}
