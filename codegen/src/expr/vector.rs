//! 3-vectors, 3x3 matrices and symmetric tensors of expressions.

use super::{Expr, ExprGraph};

/// Components along x, y, z.
pub type Vector = [Expr; 3];

/// Rows of a 3x3 matrix.
pub type Matrix = [[Expr; 3]; 3];

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the axes have no other names")]
pub enum Axis {
    X,
    Y,
    Z,
}

/// A symmetric 3x3 tensor: the diagonal xx, yy, zz, and yz, zx, xy, each beside the axis that it leaves out.
#[derive(Clone, Copy, Debug)]
pub struct Symmetric {
    /// xx, yy, zz.
    pub diagonal: Vector,
    /// yz, zx, xy.
    pub mixed: Vector,
}

impl Axis {
    /// x, y, z.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// 0, 1, 2.
    pub fn index(self) -> usize {
        self as usize
    }

    /// The other two axes, in cyclic order: y, z for x.
    pub fn others(self) -> (usize, usize) {
        ((self.index() + 1) % 3, (self.index() + 2) % 3)
    }

    /// "x", "y", "z".
    pub fn letter(self) -> &'static str {
        ["x", "y", "z"][self.index()]
    }
}

impl Symmetric {
    /// One column (or row).
    pub fn column(&self, column: usize) -> Vector {
        std::array::from_fn(|row| self.entry(row, column))
    }

    /// One entry.
    pub fn entry(&self, row: usize, column: usize) -> Expr {
        if row == column {
            self.diagonal[row]
        } else {
            self.mixed[3 - row - column]
        }
    }
}

impl ExprGraph {
    /// The zero vector.
    pub fn zero_vector(&mut self) -> Vector {
        [self.zero(); 3]
    }

    /// The zero tensor.
    pub fn zero_symmetric(&mut self) -> Symmetric {
        Symmetric {
            diagonal: self.zero_vector(),
            mixed: self.zero_vector(),
        }
    }

    /// The unit vector along an axis.
    pub fn unit_vector(&mut self, axis: usize) -> Vector {
        let mut unit = self.zero_vector();
        unit[axis] = self.one();
        unit
    }

    /// The identity matrix.
    pub fn identity(&mut self) -> Matrix {
        [
            self.unit_vector(0),
            self.unit_vector(1),
            self.unit_vector(2),
        ]
    }

    /// True for a vector of three zeros.
    pub fn is_zero_vector(&self, v: Vector) -> bool {
        v.iter().all(|&component| self.is_zero(component))
    }

    /// `a + b`.
    pub fn add_vectors(&mut self, a: Vector, b: Vector) -> Vector {
        std::array::from_fn(|i| self.add(a[i], b[i]))
    }

    /// `a - b`.
    pub fn sub_vectors(&mut self, a: Vector, b: Vector) -> Vector {
        std::array::from_fn(|i| self.sub(a[i], b[i]))
    }

    /// `2 v`.
    pub fn doubled(&mut self, v: Vector) -> Vector {
        let two = self.number(2.0);
        self.scale(two, v)
    }

    /// `k v`.
    pub fn scale(&mut self, k: Expr, v: Vector) -> Vector {
        v.map(|component| self.mul(k, component))
    }

    /// `a · b`.
    pub fn dot(&mut self, a: Vector, b: Vector) -> Expr {
        // Each product stands beside the sum that takes it, so that the whole reads as one line.
        let mut sum = self.mul(a[0], b[0]);
        for i in 1..3 {
            let term = self.mul(a[i], b[i]);
            sum = self.add(sum, term);
        }
        sum
    }

    /// `a × b`.
    pub fn cross(&mut self, a: Vector, b: Vector) -> Vector {
        Axis::ALL.map(|axis| {
            let (j, k) = axis.others();
            let plus = self.mul(a[j], b[k]);
            let minus = self.mul(a[k], b[j]);
            self.sub(plus, minus)
        })
    }

    /// `m v`.
    pub fn mul_vector(&mut self, m: &Matrix, v: Vector) -> Vector {
        m.map(|row| self.dot(row, v))
    }

    /// `a b`.
    pub fn mul_matrices(&mut self, a: &Matrix, b: &Matrix) -> Matrix {
        let columns = transpose(b);
        a.map(|row| columns.map(|column| self.dot(row, column)))
    }

    /// The sum of two tensors.
    pub fn add_symmetric(&mut self, a: &Symmetric, b: &Symmetric) -> Symmetric {
        Symmetric {
            diagonal: self.add_vectors(a.diagonal, b.diagonal),
            mixed: self.add_vectors(a.mixed, b.mixed),
        }
    }

    /// `I v` for a symmetric tensor.
    pub fn mul_symmetric(&mut self, tensor: &Symmetric, v: Vector) -> Vector {
        std::array::from_fn(|row| self.dot(tensor.column(row), v))
    }

    /// `m^T I m`: the symmetric tensor before a rotation `m`, given by its components after it.
    pub fn turn_back_symmetric(&mut self, m: &Matrix, tensor: &Symmetric) -> Symmetric {
        if *m == self.identity() {
            return *tensor;
        }
        let columns = transpose(m);
        let turned = columns.map(|column| self.mul_symmetric(tensor, column));
        Symmetric {
            diagonal: std::array::from_fn(|i| self.dot(columns[i], turned[i])),
            mixed: Axis::ALL.map(|axis| {
                let (i, j) = axis.others();
                self.dot(columns[i], turned[j])
            }),
        }
    }

    /// Labels the components of a vector `text_x`, `text_y`, `text_z`.
    pub fn name_vector(&mut self, v: Vector, text: &str) {
        for axis in Axis::ALL {
            self.name_by(v[axis.index()], || format!("{text}_{}", axis.letter()));
        }
    }

    /// Labels each component by a text of its own.
    pub fn name_each(&mut self, v: Vector, texts: [&str; 3]) {
        for (component, text) in v.into_iter().zip(texts) {
            self.name(component, text);
        }
    }

    /// Labels the entries of a matrix `text_xx`, `text_xy`, and so on.
    pub fn name_matrix(&mut self, m: &Matrix, text: &str) {
        for (row, axis) in m.iter().zip(Axis::ALL) {
            for (entry, other) in row.iter().zip(Axis::ALL) {
                self.name_by(*entry, || {
                    format!("{text}_{}{}", axis.letter(), other.letter())
                });
            }
        }
    }
}

/// The negative of a vector.
pub fn negated(v: Vector) -> Vector {
    v.map(|component| -component)
}

/// The transposed matrix.
pub fn transpose(m: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| m[j][i]))
}
