//! Which numbers an argument holds, and in what order.

use kane_codegen::functions::{Access, Declared, Element, Length, Unit};
use kane_codegen::listing::{Extent, Member, Size, Sizes, Step};

const ELEMENTS: [Element; 5] = [
    Element::Scalar,
    Element::Load,
    Element::Parameters,
    Element::Prepared,
    Element::SinCos,
];

/// What an argument holds in a module with three angles, parameters and prepared values.
fn extent(element: Element, lengths: &[usize]) -> Extent {
    let argument = Declared {
        name: "a".to_owned(),
        element,
        lengths: lengths.iter().copied().map(Length::Number).collect(),
        access: Access::Read,
        meaning: "".into(),
        unit: Unit::UNKNOWN,
    };
    let angles = Size {
        name: "NA".to_owned(),
        value: 3,
        doc: String::new(),
        brief: "",
    };
    Extent::of(&argument, &Sizes(vec![angles]), 3, 3)
}

#[test]
fn steps_lead_to_the_place_that_they_are_of() {
    for element in ELEMENTS {
        for lengths in [&[][..], &[4], &[2, 3], &[2, 3, 2]] {
            let extent = extent(element, lengths);
            for place in 0..extent.size() {
                assert_eq!(extent.place(&extent.steps(place)), Some(place));
            }
        }
    }
}

#[test]
fn steps_beyond_lead_nowhere() {
    let loads = extent(Element::Load, &[2]);
    let force = [Step::Index(1), Step::Member(Member::Force), Step::Index(2)];
    assert_eq!(loads.place(&force), Some(8));
    for (changed, step) in [
        (0, Step::Index(2)),
        (1, Step::Member(Member::Sines)),
        (2, Step::Index(3)),
    ] {
        let mut steps = force;
        steps[changed] = step;
        assert_eq!(loads.place(&steps), None, "{steps:?}");
    }
    assert_eq!(loads.place(&force[..2]), None);
    assert_eq!(loads.place(&[&force[..], &force[..1]].concat()), None);
    assert_eq!(extent(Element::Scalar, &[0]).place(&[Step::Index(0)]), None);
}
