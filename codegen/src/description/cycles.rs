//! Cycles among things of which each hangs from one other, or from none.

/// Every cycle once, from its member with the lowest place on; `lower` is what each place hangs from.
pub(crate) fn cycles(lower: &[Option<usize>]) -> Vec<Vec<usize>> {
    // From which start a place was first reached; one reached twice from one start lies on a cycle.
    let mut reached: Vec<Option<usize>> = vec![None; lower.len()];
    let mut cycles = Vec::new();
    for start in 0..lower.len() {
        let mut here = Some(start);
        while let Some(place) = here.filter(|place| reached[*place].is_none()) {
            reached[place] = Some(start);
            here = lower[place];
        }
        if let Some(entry) = here.filter(|place| reached[*place] == Some(start)) {
            let around = std::iter::successors(lower[entry], |place| lower[*place])
                .take_while(|place| *place != entry);
            let mut cycle: Vec<usize> = std::iter::once(entry).chain(around).collect();
            let lowest = (0..cycle.len())
                .min_by_key(|place| cycle[*place])
                .unwrap_or(0);
            cycle.rotate_left(lowest);
            cycles.push(cycle);
        }
    }
    cycles
}
