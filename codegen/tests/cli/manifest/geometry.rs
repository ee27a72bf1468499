//! Joints and frames of a manifest, compared with what models say and with what functions compute.

use kane_test_support::{
    compare::{Tolerance, assert_close},
    json::flat,
    models::body,
    rotation::{IDENTITY, Rotation, about, product, sum, times, transposed},
};
use serde_json::{Value, json};

use super::super::project::Project;

/// Links in a row: each type of joint that has an axis, fixed links between them, and a gripper.
const ROBOT: &str = r#"<robot name="robot">
  <link name="world"/>
  <joint name="mount" type="fixed">
    <parent link="world"/><child link="stand"/><origin xyz="0 0 0.5" rpy="0 0 0.4"/>
  </joint>
  <link name="stand"/>
  <joint name="lift" type="prismatic">
    <parent link="stand"/><child link="carriage"/><origin xyz="0.1 0.2 0.3" rpy="0.3 -0.2 0.1"/>
    <axis xyz="0 0 -2"/><limit lower="-1" upper="1" velocity="1" effort="1"/>
  </joint>
  <link name="carriage"><inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="turn" type="continuous">
    <parent link="carriage"/><child link="arm"/><origin xyz="0 0.5 0" rpy="0 0.7 0"/><axis xyz="0 0.6 0.8"/>
  </joint>
  <link name="arm"><inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="flange" type="fixed">
    <parent link="arm"/><child link="tool"/><origin xyz="0.4 0.1 0" rpy="0 0 1.1"/>
  </joint>
  <link name="tool"/>
  <joint name="left" type="revolute">
    <parent link="tool"/><child link="left finger"/><origin xyz="0 0.03 0"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" velocity="1" effort="1"/>
  </joint>
  <link name="left finger"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="right" type="revolute">
    <parent link="tool"/><child link="right finger"/><origin xyz="0 -0.03 0"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" velocity="1" effort="1"/><mimic joint="left" multiplier="-0.5" offset="0.25"/>
  </joint>
  <link name="right finger"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
</robot>"#;

/// Frames in a body whose own origin moves, on a body fixed to it, and in the inertial frame; many numbers are set at run time.
const FRAMES: &str = r#"
name = "robot"
lower_bodies = [0, 1]

[[body]]
name = "arm"
mass = 1.5
mass_center = [0.1, 0.02, -0.4]
inertia = { xx = 0.1, yy = 0.1, zz = 0.02, xy = 0.0, xz = 0.01, yz = 0.0 }
attachment = [{ runtime = 0.2 }, 0.0, -1.0]
body_attachment = [0.0, { runtime = 0.3 }, 0.1]
body_rotation = [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]]
joint = ["theta2", "s1"]
locked = { theta3 = 0.5 }

[[body]]
name = "hand"
mass = 0.5
mass_center = [0.0, 0.0, 0.1]
inertia = { xx = 0.01, yy = 0.01, zz = 0.01, xy = 0.0, xz = 0.0, yz = 0.0 }
attachment = [0.0, { runtime = 0.05 }, -0.75]
attachment_rotation = [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
joint = "fixed"

[[frame]]
name = "Tool 0"
body = "hand"
position = [{ runtime = 0.125 }, 0.0, 0.25]
rotation = { runtime = [[0.6, 0.0, -0.8], [0.0, 1.0, 0.0], [0.8, 0.0, 0.6]] }

[[frame]]
name = "camera"
body = "arm"
position = [0.5, 0.25, { runtime = -0.125 }]
rotation = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]

[[frame]]
name = "table"
position = [1.0, 2.0, 3.0]
"#;

/// A project with this model, and its manifest.
fn generated(name: &str, model: &str) -> (Project, Value) {
    super::generated([name, model], "robot", "functions = [\"q_dot\"]\n")
}

fn record<'m>(manifest: &'m Value, list: &str, name: &str) -> &'m Value {
    let mut records = manifest[list].as_array().unwrap().iter();
    records.find(|record| record["name"] == name).unwrap()
}

fn vector(value: &Value) -> [f64; 3] {
    flat(value).try_into().unwrap()
}

fn rotation(value: &Value) -> Rotation {
    [0, 1, 2].map(|row| vector(&value[row]))
}

/// What a function computes of the model in a state.
fn eval(project: &Project, model: &str, function: &str, state: &Value) -> Value {
    let arguments = ["eval", model, "--function", function, "--state", "-"];
    let ran = project.kane_given(&arguments, &state.to_string());
    assert_eq!(ran.code, 0, "{function}: {}", ran.err);
    serde_json::from_str(&ran.out).unwrap()
}

/// To the axes of an `rpy`: about the fixed x, y, z, one after the other.
fn rpy(angles: [f64; 3]) -> Rotation {
    let [roll, pitch, yaw] = [0, 1, 2].map(|i| about(IDENTITY[i], angles[i]));
    product(&roll, &product(&pitch, &yaw))
}

#[track_caller]
fn close(found: &Value, expected: &[f64]) {
    assert_close(
        "manifest",
        &flat(found),
        expected,
        Tolerance::absolute(1e-12),
    );
}

#[test]
fn joints_of_a_urdf_have_its_types_axes_and_origins() {
    let (_, manifest) = generated("robot.urdf", ROBOT);
    // Of what is fixed the pose in the body that carries it.
    let stand = rpy([0.0, 0.0, 0.4]);
    let tool = rpy([0.0, 0.0, 1.1]);
    let on_tool = |y: f64| sum([0.4, 0.1, 0.0], times(&transposed(&tool), [0.0, y, 0.0]));
    let lift = times(&transposed(&stand), [0.1, 0.2, 0.3]);
    // The position in the lower body, the rotation to the link's axes, and the axis along these.
    for (name, kind, position, rotation, axis) in [
        (
            "lift",
            "prismatic",
            sum([0.0, 0.0, 0.5], lift),
            product(&rpy([0.3, -0.2, 0.1]), &stand),
            [0.0, 0.0, -1.0],
        ),
        (
            "turn",
            "continuous",
            [0.0, 0.5, 0.0],
            rpy([0.0, 0.7, 0.0]),
            [0.0, 0.6, 0.8],
        ),
        ("left", "revolute", on_tool(0.03), tool, [0.0, 1.0, 0.0]),
        ("right", "revolute", on_tool(-0.03), tool, [0.0, 1.0, 0.0]),
    ] {
        let joint = record(&manifest, "joints", name);
        assert_eq!(joint["kind"], kind, "{name}");
        close(&joint["position"], &position);
        let names = ["theta1", "theta2", "theta3", "s1", "s2", "s3"];
        let places = joint["u"].as_array().unwrap().iter().zip(names);
        let mut moving = places
            .filter(|(place, name)| place.is_u64() || joint["mimic"]["coordinate"] == json!(name));
        let (_, motion) = moving.next().unwrap();
        let motion = names.iter().position(|own| *own == motion).unwrap();
        assert!(moving.next().is_none());
        close(&joint["body_axes"][motion % 3], &axis);
        let on_lower = times(&transposed(&rotation), axis);
        close(&joint["axes"][motion % 3], &on_lower);
    }
}

#[test]
fn joint_that_follows_says_whom_and_how() {
    let (_, manifest) = generated("robot.urdf", ROBOT);
    let left = record(&manifest, "joints", "left")["q"].as_array().unwrap();
    let leader = left.iter().find_map(Value::as_u64).unwrap();
    assert_eq!(
        manifest["coordinates"][usize::try_from(leader).unwrap()],
        "left"
    );
    assert_eq!(
        record(&manifest, "joints", "right")["mimic"],
        json!({ "coordinate": "theta2", "joint": "left", "leader": leader, "multiplier": -0.5, "offset": 0.25 })
    );
    assert!(record(&manifest, "joints", "left").get("mimic").is_none());
}

#[test]
fn axes_are_those_of_velocities() {
    let (project, manifest) = generated("robot.toml", FRAMES);
    let joint = record(&manifest, "joints", "arm");
    assert_eq!(joint["kind"], Value::Null);
    assert_eq!(joint["locked"], json!({ "theta3": 0.5 }));
    let state = |u: [f64; 2]| json!({ "q": [0.0, 0.0], "u": u });
    let sliding = eval(
        &project,
        "robot.toml",
        "origin_velocity",
        &state([0.0, 2.0]),
    );
    let axis = vector(&joint["axes"][0]);
    close(&sliding[0], &axis.map(|part| 2.0 * part));
    // Behind the held third angle the second axis stands turned in the body.
    let turning = eval(
        &project,
        "robot.toml",
        "relative_angular_velocity",
        &state([2.0, 0.0]),
    );
    let axes = rotation(&joint["body_axes"]);
    let in_joint = about(IDENTITY[2], 0.5).map(|axis| 2.0 * axis[1]);
    let second = times(&transposed(&axes), in_joint);
    close(&turning[0], &second);
}

#[test]
fn frames_stand_where_poses_say() {
    let (project, manifest) = generated("robot.toml", FRAMES);
    let listed: Vec<&Value> = manifest["frames"]
        .as_array()
        .unwrap()
        .iter()
        .map(|frame| &frame["name"])
        .collect();
    assert_eq!(listed, ["hand", "Tool 0", "camera", "table"]);
    assert_eq!(
        record(&manifest, "frames", "Tool 0")["identifier"],
        "tool_0"
    );
    assert_eq!(record(&manifest, "frames", "table")["body"], Value::Null);
    let state = json!({ "q": [0.3, -0.2] });
    for name in ["hand", "Tool 0", "camera"] {
        let frame = record(&manifest, "frames", name);
        assert_eq!(frame["body"], 0, "{name}");
        let pose = eval(
            &project,
            "robot.toml",
            &format!("pose(\"{name}\", arm)"),
            &state,
        );
        for part in ["rotation", "position"] {
            close(&frame[part], &flat(&pose[part]));
        }
    }
    let table = eval(&project, "robot.toml", "pose(table)", &state);
    close(
        &record(&manifest, "frames", "table")["position"],
        &flat(&table["position"]),
    );
}

#[test]
fn parameters_move_and_turn_frames_as_they_say() {
    let (project, manifest) = generated("robot.toml", FRAMES);
    let names = manifest["parameters"].as_array().unwrap().iter();
    let nominal: Vec<(&str, f64)> = names
        .map(|own| {
            (
                own["name"].as_str().unwrap(),
                own["nominal"].as_f64().unwrap(),
            )
        })
        .collect();
    let changed = |name: &str, nominal: f64| nominal + 0.01 * (name.len() as f64);
    let values: serde_json::Map<String, Value> = nominal
        .iter()
        .map(|&(name, value)| (name.to_owned(), json!(changed(name, value))))
        .collect();
    let state = json!({ "q": [0.3, -0.2], "parameters": values });
    let mut moving = Vec::new();
    for name in ["hand", "Tool 0", "camera"] {
        let frame = record(&manifest, "frames", name);
        let mut position = vector(&frame["position"]);
        for moved in frame["moved_by"].as_array().unwrap() {
            let parameter = moved["parameter"].as_str().unwrap();
            let along = vector(&moved["along"]);
            let (_, nominal) = nominal.iter().find(|(own, _)| *own == parameter).unwrap();
            let by = changed(parameter, *nominal) - nominal;
            position = [0, 1, 2].map(|i| position[i] + by * along[i]);
            moving.push(parameter);
        }
        let pose = eval(
            &project,
            "robot.toml",
            &format!("pose(\"{name}\", arm)"),
            &state,
        );
        close(&pose["position"], &position);
        let Some(turned) = frame.get("turned_by") else {
            close(&pose["rotation"], &flat(&frame["rotation"]));
            continue;
        };
        let names = &turned["parameters"];
        let value = |name: &Value| values[name.as_str().unwrap()].as_f64().unwrap();
        let matrix = [0, 1, 2].map(|i| [0, 1, 2].map(|j| value(&names[i][j])));
        let turned = product(&matrix, &rotation(&turned["after"]));
        close(&pose["rotation"], turned.as_flattened());
    }
    assert_eq!(
        moving,
        [
            "hand_attachment_y",
            "hand_attachment_y",
            "tool_0_position_x",
            "camera_position_z"
        ]
    );
    // The body's own origin moves with one parameter, its joint with another.
    let joint = record(&manifest, "joints", "arm");
    assert_eq!(
        joint["moved_by"],
        json!([{ "parameter": "arm_attachment_x", "along": [1.0, 0.0, 0.0] }])
    );
}

#[test]
fn site_of_an_mjcf_is_a_frame() {
    let model = r#"<mujoco model="robot"><compiler angle="radian"/><worldbody>
      <body name="arm" pos="0 0 1"><inertial pos="0 0 0.1" mass="1" diaginertia="1 1 1"/><joint name="hinge" axis="0 1 0"/>
        <site name="tip" pos="0.1 0.2 0.3" xyaxes="0 1 0 -1 0 0"/></body>
    </worldbody></mujoco>"#;
    let (_, manifest) = generated("robot.xml", model);
    assert_eq!(
        record(&manifest, "frames", "tip"),
        &json!({
            "name": "tip",
            "identifier": "tip",
            "body": 0,
            "rotation": [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
            "position": [0.1, 0.2, 0.3],
        })
    );
    let joint = record(&manifest, "joints", "hinge");
    assert_eq!(
        (&joint["kind"], &joint["position"]),
        (&json!("continuous"), &json!([0.0, 0.0, 1.0]))
    );
}

#[test]
fn kinds_are_those_that_models_name() {
    for (kind, more) in [
        (
            "revolute",
            "axis = [0.0, 0.6, 0.8]\nlimits = { upper = 1.0 }\n",
        ),
        ("continuous", "axis = [0.0, 0.6, 0.8]\n"),
        ("prismatic", "axis = [1.0, 0.0, 0.0]\n"),
        ("cylindrical", "axis = [0.0, -1.0, 0.0]\n"),
        ("planar", "axis = [0.0, 0.0, 1.0]\n"),
        ("universal", ""),
        ("spherical", ""),
        ("free", "chart = \"quaternion\"\n"),
    ] {
        let body = body("arm", &format!("\"{kind}\"\n{more}"));
        let model = format!("name = \"robot\"\nlower_bodies = [0]\n{body}");
        let (_, manifest) = generated("robot.toml", &model);
        assert_eq!(record(&manifest, "joints", "arm")["kind"], kind);
    }
}
