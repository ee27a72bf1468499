//! Limits that are none.

use kane_codegen::{description::Reading, tree};

use super::{joint, limits, parse, robot, told};

#[test]
fn infinite_limits_are_none() {
    for infinity in ["inf", "+inf", "INF", "Infinity", " inf ", "1e999"] {
        let limit = format!(
            "<limit lower=\"-1\" upper=\"{infinity}\" effort=\"{infinity}\" velocity=\"{infinity}\"/>"
        );
        let of = |kind| limits(&joint(kind, &limit));
        assert_eq!(of("revolute"), Some([Some(-1.0), None, None, None]));
        assert_eq!(of("prismatic"), Some([Some(-1.0), None, None, None]));
        let limit = limit.replace(
            "\"-1\"",
            &format!("\"-{}\"", infinity.trim_matches([' ', '+'])),
        );
        for kind in ["revolute", "prismatic", "continuous"] {
            assert_eq!(limits(&joint(kind, &limit)), Some([None; 4]), "{limit}");
        }
    }
    let largest = "<limit lower=\"-1e308\" upper=\"1e308\" effort=\"1e308\" velocity=\"1e308\"/>";
    let all = Some([Some(-1e308), Some(1e308), Some(1e308), Some(1e308)]);
    assert_eq!(limits(&joint("revolute", largest)), all);
}

#[test]
fn infinities_of_the_other_sign_are_refused() {
    for limit in [
        "lower=\"inf\"",
        "upper=\"-inf\"",
        "effort=\"-inf\"",
        "velocity=\"-inf\"",
        "upper=\"nan\"",
        "effort=\"NaN\"",
    ] {
        let limit = format!("<limit {limit}/>");
        let description = parse(
            &robot(&[("j", "revolute", "a", "b", &limit)]),
            &Reading::default(),
        );
        let told = told(&description);
        let is_told = |message: &&str| message.ends_with("expected a finite number");
        assert!(told.iter().any(is_told), "{limit}: {told:?}");
        assert!(tree::build(&description).is_err());
    }
}
