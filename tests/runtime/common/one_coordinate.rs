/// Makes a structure, generic in its scalar, a system of one body with one coordinate, whose rate is the speed.
macro_rules! one_coordinate {
    ($system:ident, $name:literal, body $body:literal, coordinate $coordinate:literal) => {
        impl<R: kane::Real> kane::System<R> for $system<R> {
            type Q = [R; 1];
            type U = [R; 1];
            type Loads = [kane::Load<R>; 1];
            type Scalars = [R; 1];
            type Vectors = [[R; 3]; 1];
            type Rotations = [[[R; 3]; 3]; 1];

            const NAME: &'static str = $name;
            const BODY_NAMES: &'static [&'static str] = &[$body];
            const COORDINATE_NAMES: &'static [&'static str] = &[$coordinate];
            const SPEED_NAMES: &'static [&'static str] = &[concat!($coordinate, "_dot")];
            const LOWER_BODIES: &'static [usize] = &[0];
            const SPEED_BODIES: &'static [usize] = &[0];

            fn q_dot(&self, _: &[R; 1], u: &[R; 1], q_dot: &mut [R; 1]) {
                *q_dot = *u;
            }
        }
    };
}

pub(super) use one_coordinate;
