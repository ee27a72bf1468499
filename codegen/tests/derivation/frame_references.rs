//! Functions of frames against what shares no code with them: differences of positions at 60 digits, for offsets at run time
//! and for what is seen from another frame; MuJoCo's sites and their Jacobians.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::fs;

use kane_codegen::{
    description::{Reading, toml},
    diagnostic::Source,
    expr::Input,
    functions::Formulation,
    recursive::Plan,
    tree::{self, Tree},
};
use kane_test_support::{compare::assert_within, json::flat};
use serde_json::Value;

use crate::{
    compiled,
    frames::{EXACT, relative, request},
};

/// As in `frames.py`, with numbers that are set at run time.
const FRAMES: &str = "
[[frame]]
name = \"hand\"
body = \"{last}\"
position = [{ runtime = 0.31 }, { runtime = -0.22 }, { runtime = 0.73 }]
rotation = { runtime = [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]] }

[[frame]]
name = \"camera\"
body = \"b2\"
position = [-0.14, { runtime = 0.05 }, 0.42]
rotation = { runtime = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] }
";
const POINT: [f64; 3] = [0.3, -0.2, 0.5];

fn read(path: &str) -> String {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests");
    fs::read_to_string(format!("{root}/{path}")).unwrap()
}

/// What is asked for, in each formulation, where only coordinates, a point and nominal parameters are given.
fn evaluated(tree: &Tree, text: &str, q: &[f64]) -> [Vec<f64>; 2] {
    let request = request(tree, text);
    [Formulation::Notes, Formulation::Recursive].map(|formulation| {
        let derived = request.derive(tree, formulation, &Plan::full(tree));
        derived.graph.evaluate(&derived.roots, |input| match input {
            Input::Q(place) => q[place.index()],
            Input::Point(axis) => POINT[axis],
            Input::Parameter(place) => tree.parameters[place.index()].nominal,
            other => unreachable!("{text} reads {other:?}"),
        })
    })
}

#[test]
fn frames_move_as_differences_at_60_digits_say() {
    for name in ["chain3", "star5", "two_roots"] {
        let model = read(&format!("reference/{name}.toml"));
        let last = format!("b{}", model.matches("[[body]]").count());
        let text = model + &FRAMES.replace("{last}", &last);
        let tree = tree::build(&toml::parse(&Source::new(name, text)));
        let tree = tree.unwrap().tree;
        let states: Value = serde_json::from_str(&read(&format!("reference/{name}.json"))).unwrap();
        let cases = read(&format!("reference/{name}.frames.json"));
        let cases: Vec<Value> = serde_json::from_str(&cases).unwrap();
        assert_eq!(cases.len(), 3);
        for (case, state) in cases.iter().zip(states["cases"].as_array().unwrap()) {
            let state = &state["state"];
            let q = [flat(&state["theta"]), flat(&state["s"])].concat();
            let requests = case.as_object().unwrap();
            assert_eq!(requests.len(), 6);
            for (text, expected) in requests {
                for found in evaluated(&tree, text, &q) {
                    let error = relative(&found, &flat(expected));
                    assert_within(format!("{name}, {text}"), error, EXACT);
                }
            }
        }
    }
}

/// Places of MuJoCo's numbers in the order of ours: of a free joint the orientation before the position.
fn places(reference: &Value) -> [Vec<usize>; 2] {
    let (mut q, mut u) = (Vec::new(), Vec::new());
    for joint in reference["joints"].as_array().unwrap() {
        let place = |key: &str| usize::try_from(joint[key].as_u64().unwrap()).unwrap();
        let (first, speed) = (place("qpos"), place("qvel"));
        match joint["type"].as_str().unwrap() {
            "free" => {
                q.extend((first + 3..first + 7).chain(first..first + 3));
                u.extend((speed + 3..speed + 6).chain(speed..speed + 3));
            }
            "ball" => {
                q.extend(first..first + 4);
                u.extend(speed..speed + 3);
            }
            _ => {
                q.push(first);
                u.push(speed);
            }
        }
    }
    [q, u]
}

#[test]
fn sites_move_as_mujoco_says() {
    for name in ["sites", "humanoid"] {
        let tree = compiled::read(
            &format!("tests/mjcf/{name}/{name}.xml"),
            &Reading::default(),
        );
        let reference = read(&format!("mjcf/{name}/reference.json"));
        let reference: Value = serde_json::from_str(&reference).unwrap();
        let [of_q, of_u] = places(&reference);
        let sites = reference["sites"].as_array().unwrap();
        assert!(sites.len() >= 5);
        let states = reference["states"].as_array().unwrap();
        assert!(states.len() >= 3);
        for state in states {
            let qpos = flat(&state["qpos"]);
            let q: Vec<f64> = of_q.iter().map(|place| qpos[*place]).collect();
            for (place, site) in sites.iter().enumerate() {
                let own = site["name"].as_str().unwrap();
                let frame = format!("{own}_site");
                let is_named = tree.markers.iter().any(|marker| marker.name == frame);
                let frame = if is_named { &frame } else { own };
                let rows = |key: &str| {
                    let numbers = flat(&state[key][place]);
                    let rows = numbers.chunks_exact(tree.n_speeds);
                    let rows = rows.map(|row| of_u.iter().map(|place| row[*place]).collect());
                    rows.collect::<Vec<Vec<f64>>>().concat()
                };
                let expected = [rows("site_jacp"), rows("site_jacr")].concat();
                for found in evaluated(&tree, &format!("jacobian({frame})"), &q) {
                    let error = relative(&found, &expected);
                    assert_within(format!("{name}, {frame}"), error, EXACT);
                }
                let position = flat(&state["site_xpos"][place]);
                for found in evaluated(&tree, &format!("pose({frame})"), &q) {
                    let error = relative(&found[9..], &position);
                    assert_within(format!("{name}, {frame}, position"), error, EXACT);
                }
            }
        }
    }
}
