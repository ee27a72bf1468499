//! Sums of arrays. Nothing is indexed, so that no panic remains in a linked program.

use crate::{Array, Real};

/// `sum += factor b`.
pub(crate) fn add_scaled<R: Real, A: Array<R>>(sum: &mut A, factor: R, b: &A) {
    for (sum, b) in sum.as_mut().iter_mut().zip(b.as_ref()) {
        *sum = *sum + factor * *b;
    }
}

/// `a + factor b`.
pub(crate) fn plus_scaled<R: Real, A: Array<R>>(a: &A, factor: R, b: &A) -> A {
    let mut sum = *a;
    add_scaled(&mut sum, factor, b);
    sum
}

/// `a + b`.
pub(crate) fn plus<R: Real, A: Array<R>>(a: &A, b: &A) -> A {
    let mut sum = *a;
    for (sum, b) in sum.as_mut().iter_mut().zip(b.as_ref()) {
        *sum = *sum + *b;
    }
    sum
}

/// `factor a`.
pub(crate) fn scaled<R: Real, A: Array<R>>(factor: R, a: &A) -> A {
    let mut scaled = *a;
    for entry in scaled.as_mut() {
        *entry = factor * *entry;
    }
    scaled
}

/// Zeros.
pub(crate) fn zero<R: Real, A: Array<R>>() -> A {
    A::filled(R::from_f64(0.0))
}

/// One at this entry, zeros elsewhere.
pub(crate) fn unit<R: Real, A: Array<R>>(entry: usize) -> A {
    A::from_fn(|place| R::from_f64(if place == entry { 1.0 } else { 0.0 }))
}

/// `a *= factor`, a matrix by rows.
pub(crate) fn scale_rows<R: Real, Row: Array<R>, M: Array<Row>>(a: &mut M, factor: R) {
    for row in a.as_mut() {
        *row = scaled(factor, row);
    }
}

/// `product = factor a`, matrices by rows.
pub(crate) fn set_scaled_rows<R: Real, Row: Array<R>, M: Array<Row>>(
    product: &mut M,
    factor: R,
    a: &M,
) {
    for (product, row) in product.as_mut().iter_mut().zip(a.as_ref()) {
        *product = scaled(factor, row);
    }
}

/// `sum += factor b`, matrices by rows.
pub(crate) fn add_scaled_rows<R: Real, Row: Array<R>, M: Array<Row>>(
    sum: &mut M,
    factor: R,
    b: &M,
) {
    for (sum, b) in sum.as_mut().iter_mut().zip(b.as_ref()) {
        add_scaled(sum, factor, b);
    }
}

/// `sum += factor a b`, matrices by rows.
///
/// A row of the product is a sum of rows of `b`, whose entries are added side by side; down a column they would wait for one another.
pub(crate) fn add_product<R: Real, U: Array<R>, Row: Array<R>, A: Array<U>, M: Array<Row>>(
    sum: &mut M,
    factor: R,
    a: &A,
    b: &M,
) {
    for (sum, entries) in sum.as_mut().iter_mut().zip(a.as_ref()) {
        // A copy, which may stay in registers.
        let mut own = *sum;
        for (entry, row) in entries.as_ref().iter().zip(b.as_ref()) {
            add_scaled(&mut own, factor * *entry, row);
        }
        *sum = own;
    }
}

/// `sum += 1`, a square matrix by rows.
pub(crate) fn add_identity<R: Real, Row: Array<R>, M: Array<Row>>(sum: &mut M) {
    for (place, row) in sum.as_mut().iter_mut().enumerate() {
        if let Some(entry) = row.as_mut().get_mut(place) {
            *entry = *entry + R::from_f64(1.0);
        }
    }
}
