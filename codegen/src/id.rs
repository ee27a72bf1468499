//! Typed indexes. Each counts from 0 in the order of its arena, so a plain `usize` never says what it indexes.

macro_rules! id {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(u32);

        impl $name {
            /// The id with this index.
            ///
            /// # Panics
            /// If `index` exceeds `u32::MAX`; no arena here comes near.
            pub fn new(index: usize) -> Self {
                Self(u32::try_from(index).expect("arenas hold fewer than 2^32 items"))
            }

            /// The index, from 0.
            pub fn index(self) -> usize {
                self.0 as usize
            }
        }
    };
}

id! {
    /// A body, in the order of the tree: a lower body (parent) has the smaller id.
    BodyId
}
id! {
    /// A generalized coordinate: an entry of `q`.
    CoordinateId
}
id! {
    /// A generalized speed: an entry of `u`, and of `u_dot` and `tau`.
    SpeedId
}
id! {
    /// A value that the user sets at run time: a field of `Parameters`.
    ParameterId
}

/// One value for each body.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyMap<T>(Vec<T>);

impl<T> BodyMap<T> {
    /// The map of `n_bodies` bodies whose values `f` makes, from the inertial frame outward; `f` sees those already made.
    pub fn outward(n_bodies: usize, mut f: impl FnMut(BodyId, &Self) -> T) -> Self {
        let mut map = Self(Vec::with_capacity(n_bodies));
        for index in 0..n_bodies {
            let value = f(BodyId::new(index), &map);
            map.0.push(value);
        }
        map
    }

    /// The values in the order of bodies.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = &T> + ExactSizeIterator {
        self.0.iter()
    }

    /// The values in the order of bodies.
    pub fn into_values(self) -> impl DoubleEndedIterator<Item = T> + ExactSizeIterator {
        self.0.into_iter()
    }
}

impl<A, B> BodyMap<(A, B)> {
    /// A map of pairs as a pair of maps.
    pub fn unzip(self) -> (BodyMap<A>, BodyMap<B>) {
        let (first, second) = self.0.into_iter().unzip();
        (BodyMap(first), BodyMap(second))
    }
}

impl<T> std::ops::Index<BodyId> for BodyMap<T> {
    type Output = T;

    fn index(&self, body: BodyId) -> &T {
        &self.0[body.index()]
    }
}

impl<T> std::ops::IndexMut<BodyId> for BodyMap<T> {
    fn index_mut(&mut self, body: BodyId) -> &mut T {
        &mut self.0[body.index()]
    }
}
