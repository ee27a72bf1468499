/// Makes a structure a system of one body with one coordinate, whose rate is the speed: generic in its scalar, or of the one
/// that stands in brackets before it.
macro_rules! one_coordinate {
    ($system:ident, $($named:tt)+) => {
        one_coordinate!(impl[R: kane::Real] R, $system<R>, $($named)+);
    };
    ([$scalar:ty] $system:ident, $($named:tt)+) => {
        one_coordinate!(impl[] $scalar, $system, $($named)+);
    };
    (
        impl[$($generic:tt)*] $scalar:ty, $system:ty,
        $name:literal, body $body:literal, coordinate $coordinate:literal
    ) => {
        impl<$($generic)*> kane::System<$scalar> for $system {
            type Q = [$scalar; 1];
            type U = [$scalar; 1];
            type Matrix = [[$scalar; 1]; 1];
            type Loads = [kane::Load<$scalar>; 1];
            type Scalars = [$scalar; 1];
            type Vectors = [[$scalar; 3]; 1];
            type Rotations = [[[$scalar; 3]; 3]; 1];

            const NAME: &'static str = $name;
            const BODY_NAMES: &'static [&'static str] = &[$body];
            const COORDINATE_NAMES: &'static [&'static str] = &[$coordinate];
            const SPEED_NAMES: &'static [&'static str] = &[concat!($coordinate, "_dot")];
            const LOWER_BODIES: &'static [usize] = &[0];
            const SPEED_BODIES: &'static [usize] = &[0];

            fn q_dot(&self, _: &[$scalar; 1], u: &[$scalar; 1], q_dot: &mut [$scalar; 1]) {
                *q_dot = *u;
            }
        }
    };
}

pub(crate) use one_coordinate;
