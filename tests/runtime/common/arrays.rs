/// The arrays of a system of so many coordinates, speeds and bodies.
macro_rules! arrays {
    ($scalar:ty; $n_coordinates:literal, $n_speeds:literal, $n_bodies:literal) => {
        type Q = [$scalar; $n_coordinates];
        type U = [$scalar; $n_speeds];
        type Matrix = [[$scalar; $n_speeds]; $n_speeds];
        type Loads = [kane::Load<$scalar>; $n_bodies];
        type Scalars = [$scalar; $n_bodies];
        type Vectors = [[$scalar; 3]; $n_bodies];
        type Rotations = [[[$scalar; 3]; 3]; $n_bodies];
    };
}

pub(crate) use arrays;
