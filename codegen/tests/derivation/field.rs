//! Numbers modulo a prime, in which zeros are exact.

use kane_codegen::drawn::Field;
use kane_codegen::number::Number;

#[test]
fn numbers_keep_what_holds_of_them() {
    let numbers = [0.3, -2.75, 1e-300, 5e-324, 7e200, 0.123_456_789_012_3].map(Field::constant);
    for a in numbers {
        assert_eq!(a * (Field::ONE / a), Field::ONE);
        assert_eq!(a + -a, Field::ZERO);
        let (sin, cos) = a.sin_cos();
        assert_eq!(sin * sin + cos * cos, Field::ONE);
    }
    let sum = Field::constant(0.25) + Field::constant(-3.0);
    assert_eq!(sum, Field::constant(-2.75));
    assert_eq!(Field::constant(f64::NAN), Field::ZERO);
}

#[test]
fn fractions_are_exact_whatever_was_rounded() {
    let third = Field::constant(1.0 / 3.0);
    assert_eq!(third + third + third, Field::ONE);
    let (a, b) = (3.0 / 7.0, 5.0 / 11.0);
    assert_eq!(
        Field::constant(a * b),
        Field::constant(a) * Field::constant(b)
    );
    let sum = Field::constant(a) + -Field::constant(b);
    assert_eq!(Field::constant(a - b), sum);
}
