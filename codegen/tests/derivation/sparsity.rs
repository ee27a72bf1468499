//! Which entries of derivatives are left out, whatever the numbers are; all others are not zero where numbers are drawn.

use std::collections::BTreeSet;

use kane_codegen::{
    description::{Base, Reading},
    functions::{Packed, Request, Sparsity, colors},
    id::SpeedId,
    recursive::Plan,
    tree::{Motion, Tree, Value},
};
use kane_test_support::{
    compare::{assert_within, larger, largest},
    dynamics::State,
    random::Random,
    systems::trees,
};

use crate::{
    compiled::read,
    derivatives::{EXACT, INVERTED, inverts, n_entries, values, ways},
    frames::{evaluate_by, request, system},
    products::third,
};

/// What rounding leaves of a zero at most, relative to the largest entry: more is none.
const ROUNDING: f64 = 1e-14;

/// Seeds of numbers that trees are given here.
const DRAWN: [u64; 2] = [71, 72];

/// The tree with drawn numbers, also of what is set at run time.
fn drawn(tree: &Tree, seed: u64) -> Tree {
    let mut drawn = tree.with_drawn_numbers(seed);
    let numbers = Random::new(seed).numbers(drawn.parameters.len());
    for (parameter, number) in drawn.parameters.iter_mut().zip(numbers) {
        parameter.nominal = number;
    }
    drawn
}

fn sparsity(tree: &Tree, text: &str) -> Sparsity {
    let request = request(tree, text);
    let sparsity = request.parts()[0].sparsity(tree);
    Sparsity::clone(&sparsity.expect("it is packed"))
}

/// All derivatives at a state drawn by the seed.
fn whole(tree: &Tree, text: &str, seed: u64) -> Vec<f64> {
    let state = State::random(tree, seed);
    values(tree, &request(tree, text), &Plan::full(tree), &state)
}

/// Of each entry whether it is left out.
fn left_out(places: &[[usize; 2]], n: usize, n_all: usize) -> Vec<bool> {
    let mut left_out = vec![true; n_all];
    for [row, column] in places {
        left_out[row * n + column] = false;
    }
    left_out
}

#[test]
fn what_is_left_out_is_zero_and_hardly_anything_else() {
    for seed in trees::tried(591..=599) {
        let (_, tree) = system(seed);
        let drawn = DRAWN.map(|seed| drawn(&tree, seed));
        let states = [(&tree, seed), (&drawn[0], 1), (&drawn[1], 2)];
        for (name, variable) in third(&tree, seed) {
            let text = format!("d({name})/d({variable})");
            let places = sparsity(&tree, &format!("packed({text})")).places;
            let n = n_entries(&tree, &variable);
            let mut most: Vec<f64> = Vec::new();
            // Factors of base parameters are those of the nominal values: others have other zeros.
            let has_own_zeros = name == "base_parameters";
            let n_states = if has_own_zeros { 1 } else { states.len() };
            for (tree, seed) in states.into_iter().take(n_states) {
                let found = whole(tree, &text, seed);
                let scale = larger(largest(&found), 1.0);
                most.resize(found.len(), 0.0);
                for (most, own) in most.iter_mut().zip(&found) {
                    *most = larger(*most, own.abs() / scale);
                }
            }
            let allowed = if inverts(&name) { INVERTED } else { EXACT };
            let left_out = left_out(&places, n, most.len());
            let mut n_zeros = 0;
            for (place, (is_out, &most)) in left_out.iter().zip(&most).enumerate() {
                let (row, column) = (place / n, place % n);
                let what = format!("{seed}, {text}, row {row}, column {column}");
                if *is_out {
                    assert_within(what, most, allowed);
                } else if most <= ROUNDING {
                    n_zeros += 1;
                }
            }
            // Where constant rotations meet, rounding may hide that something cancels.
            let n_kept = places.len();
            assert!(
                has_own_zeros || 20 * n_zeros <= n_kept,
                "{seed}, {text}: {n_zeros} of {n_kept}"
            );
        }
    }
}

#[test]
fn nothing_that_is_kept_of_robots_is_zero() {
    for (robot, base) in [("ur5", None), ("solo12", Some(Base::Free))] {
        let path = format!("tests/robots/{robot}/{robot}.urdf");
        let tree = read(
            &path,
            &Reading {
                base,
                ..Reading::default()
            },
        );
        for text in [
            "packed(d(inverse_dynamics)/d(q, u, u_dot))",
            "packed(d(forward_dynamics)/d(q, u, tau))",
        ] {
            let [a, b] = DRAWN.map(|seed| whole(&drawn(&tree, seed), text, seed));
            assert_eq!(a.len(), sparsity(&tree, text).places.len());
            for (place, (a, b)) in a.iter().zip(&b).enumerate() {
                let most = larger(a.abs(), b.abs());
                assert!(most > ROUNDING, "{robot}, {text}, {place}: {most:e}");
            }
        }
    }
}

/// All derivatives of a function by variables, a row for each entry of its outputs, the variables' columns side by side.
fn rows(tree: &Tree, (name, by): (&str, &[&str]), numbers: &[f64]) -> Vec<Vec<f64>> {
    let mut rest = numbers;
    let mut rows = Vec::new();
    for lengths in request(tree, name).lengths(tree, 0) {
        let mut own = vec![Vec::new(); lengths.iter().product()];
        for variable in by {
            let n = n_entries(tree, variable);
            for row in &mut own {
                let (entries, others) = rest.split_at(n);
                row.extend_from_slice(entries);
                rest = others;
            }
        }
        rows.extend(own);
    }
    assert!(rest.is_empty());
    rows
}

#[test]
fn packed_derivatives_are_those_of_all_that_are_not_left_out() {
    for seed in trees::tried(601..=606) {
        let (_, tree) = system(seed);
        let state = State::random(&tree, seed);
        for (name, by) in [
            ("loaded_inverse_dynamics", &["u", "q", "loads"][..]),
            ("inverse_dynamics", &["q", "u", "u_dot"]),
            ("forward_dynamics", &["tau", "q", "u"]),
            ("loaded_forward_dynamics", &["loads", "q", "tau"]),
            ("centroidal_momentum_matrix", &["q"]),
        ] {
            let text = format!("d({name})/d({})", by.join(", "));
            let packed = request(&tree, &format!("packed({text})"));
            let all = request(&tree, &text);
            let places = sparsity(&tree, &packed.text()).places;
            for (formulation, plan) in ways(&tree) {
                let numbers =
                    |request: &Request| evaluate_by(&tree, request, formulation, &plan, &state);
                let whole = rows(&tree, (name, by), &numbers(&all));
                let expected = places.iter().map(|&[row, column]| whole[row][column]);
                let expected: Vec<f64> = expected.collect();
                // The same expressions, so the same bits.
                assert_eq!(numbers(&packed), expected, "{seed}, {text}");
            }
        }
    }
}

#[test]
fn pattern_is_the_same_however_much_of_the_weights_is_lifted() {
    let tree = read("tests/robots/ur5/ur5.urdf", &Reading::default());
    for text in [
        "packed(d(inverse_dynamics)/d(q))",
        "packed(d(gravity_forces)/d(q))",
        "packed(d(forward_dynamics)/d(q, tau))",
    ] {
        let places = sparsity(&tree, text).places;
        for share in [0.5, 1.0] {
            let mut lifted = tree.clone();
            lifted.lifted = share;
            assert_eq!(sparsity(&lifted, text).places, places, "{share}, {text}");
        }
        let mut lifted = tree.clone();
        lifted.bodies[2].parts[0].lifted = Value::Baked(0.5);
        assert_eq!(sparsity(&lifted, text).places, places, "one body, {text}");
    }
}

#[test]
fn one_request_has_a_pattern_on_each_tree() {
    let request = Request::parse("packed(d(bias)/d(q))").unwrap();
    for seed in [561, 562, 561] {
        let (_, tree) = system(seed);
        let found = request.parts()[0].sparsity(&tree).expect("it is packed");
        assert_eq!(*found, sparsity(&tree, "packed(d(bias)/d(q))"));
    }
    // Trees that differ only in what is prescribed.
    let text = "packed(d(hybrid_dynamics)/d(q, u_dot, tau))";
    let request = Request::parse(text).unwrap();
    let (_, mut tree) = system(561);
    for n_prescribed in [0, 2, tree.n_speeds] {
        tree.prescribed = (0..n_prescribed).map(SpeedId::new).collect();
        let found = request.parts()[0].sparsity(&tree).expect("it is packed");
        assert_eq!(*found, sparsity(&tree, text));
    }
}

#[test]
fn columns_of_one_colour_share_no_row() {
    let mut n_saved = 0;
    for seed in trees::tried(611..=630) {
        let (_, tree) = system(seed);
        for text in [
            "packed(d(inverse_dynamics)/d(q, u))",
            "packed(d(forward_dynamics)/d(q, u, tau))",
            "packed(d(mass_center_position)/d(q))",
        ] {
            let Sparsity {
                places,
                colors: found,
            } = sparsity(&tree, text);
            let found = found.expect("a first derivative has some");
            let known: BTreeSet<[usize; 2]> = places
                .iter()
                .map(|&[row, column]| [row, found[column]])
                .collect();
            assert_eq!(known.len(), places.len(), "{seed}, {text}");
            let n_colors = found.iter().max().map_or(0, |most| most + 1);
            n_saved += found.len() - n_colors;
        }
    }
    assert!(n_saved > 0, "some columns share no row");
}

/// The places of a packed matrix over speeds, above the diagonal too.
fn mirrored(packed: Packed, tree: &Tree) -> Vec<[usize; 2]> {
    let places = packed.places(tree).into_iter();
    let both = places.flat_map(|[row, column]| [[row, column], [column, row]]);
    let both: BTreeSet<[usize; 2]> = both.collect();
    both.into_iter().collect()
}

/// True for two motions of one joint: along axes at right angles, or about and along one axis, they need nothing of each other.
fn are_of_one_joint(tree: &Tree, [row, column]: [usize; 2]) -> bool {
    let mut motions = tree.bodies.iter().map(|body| body.joint.motions());
    let has = |motions: &[Option<Motion>; 6], speed| {
        let mut motions = motions.iter().flatten();
        motions.any(|motion| motion.speed.index() == speed)
    };
    row != column && motions.any(|own| has(&own, row) && has(&own, column))
}

#[test]
fn patterns_of_dynamics_follow_from_the_tree() {
    for seed in trees::tried(631..=651) {
        let (_, tree) = system(seed);
        let of = |text: &str| sparsity(&tree, &format!("packed({text})")).places;
        let mut coupled = mirrored(Packed::MassMatrix, &tree);
        for variable in ["q", "u"] {
            let found = of(&format!("d(inverse_dynamics)/d({variable})"));
            let is_known = |place| coupled.binary_search(place).is_ok();
            assert!(found.iter().all(is_known), "{seed}, {variable}");
        }
        let together = mirrored(Packed::Inverse, &tree);
        for variable in ["q", "u", "tau"] {
            let found = of(&format!("d(forward_dynamics)/d({variable})"));
            let is_known = |place| together.binary_search(place).is_ok();
            assert!(found.iter().all(is_known), "{seed}, {variable}");
        }
        let mut found = of("d(inverse_dynamics)/d(u_dot)");
        assert!(found.iter().all(|place| coupled.contains(place)), "{seed}");
        for places in [&mut coupled, &mut found] {
            places.retain(|place| !are_of_one_joint(&tree, *place));
        }
        assert_eq!(found, coupled, "{seed}");
    }
}

/// Two pendulums in a row, and one beside them, with numbers of their own.
fn pendulums(length: &str, mass: &str, gravity: &str, more: &str) -> Tree {
    let body = |name: &str| {
        format!(
            "[[body]]\nname = \"{name}\"\nmass = {mass}\nmass_center = [0.0, 0.0, {length}]\n\
             inertia = {{ xx = 0.1, yy = 0.1, zz = 0.1, xy = 0.0, xz = 0.0, yz = 0.0 }}\n\
             attachment = [0.0, 0.0, {length}]\njoint = [\"theta1\"]\n{more}\n"
        )
    };
    let bodies = ["a", "b", "c"].map(body).concat();
    let text = format!(
        "name = \"three\"\ngravity = [0.0, 0.0, {gravity}]\nlower_bodies = [0, 1, 0]\n{bodies}"
    );
    kane_test_support::systems::tree(&text).expect("a right description")
}

#[test]
fn patterns_do_not_change_with_values() {
    let known = pendulums("-0.5", "2.0", "-9.81", "");
    let others = [
        pendulums("0.0", "2.0", "0.0", ""),
        pendulums("{ runtime = -0.5 }", "{ runtime = 2.0 }", "-9.81", ""),
        pendulums("-0.5", "2.0", "0.0", "stiffness = 3.0\ndamping = 0.5"),
    ];
    for text in [
        "packed(d(inverse_dynamics)/d(q, u))",
        "packed(d(forward_dynamics)/d(q, u, tau))",
        "hessian(inverse_dynamics; q, u)",
        "hessian(forward_dynamics; q, u)",
    ] {
        for other in &others {
            assert_eq!(sparsity(&known, text), sparsity(other, text), "{text}");
        }
    }
    let places = sparsity(&known, "packed(d(inverse_dynamics)/d(q))").places;
    assert_eq!(places, [[0, 0], [0, 1], [1, 0], [1, 1], [2, 2]]);
}

#[test]
fn patterns_do_not_change_where_coordinates_share_a_value_set_at_run_time() {
    let floating = |armature: &str| {
        let text = format!(
            "name = \"x\"\ngravity = [0.0, 0.0, -9.81]\nlower_bodies = [0]\n\
             [[body]]\nname = \"b\"\nmass = 1.0\nmass_center = [0.1, 0.2, 0.3]\n\
             inertia = {{ xx = 0.1, yy = 0.11, zz = 0.12, xy = 0.01, xz = 0.02, yz = 0.03 }}\n\
             attachment = [0.0, 0.0, 0.0]\njoint = \"free\"\nchart = \"quaternion\"\n\
             armature = {armature}\n"
        );
        kane_test_support::systems::tree(&text).expect("a right description")
    };
    let (known, shared) = (floating("0.1"), floating("{ runtime = 0.1 }"));
    for (text, n_places) in [
        ("packed(d(mass_matrix_inverse)/d(q))", 108),
        ("packed(d(forward_dynamics_pivots)/d(q))", 9),
        ("hessian(operational_inverse_inertia(b, local); q)", 6),
    ] {
        let places = sparsity(&known, text).places;
        assert_eq!(places.len(), n_places, "{text}");
        assert_eq!(sparsity(&shared, text).places, places, "{text}");
    }
}

#[test]
fn columns_that_share_a_row_differ() {
    // An arrow: the first column meets all others, which meet none.
    let places = [[0, 0], [1, 0], [1, 1], [2, 0], [2, 2], [3, 0], [3, 3]];
    assert_eq!(colors(&places, 5), [0, 1, 1, 1, 0]);
}
