//! What a build script writes, from its folder of models.

use kane_codegen::build_script::Build;
use kane_codegen::companions::Abi;

#[test]
fn manifest_is_written_beside_the_module() {
    let folder = tempfile::tempdir().unwrap();
    let build = Build::new("tests/models/pendulum.toml").name("swing");
    let files = |build: &Build| {
        let module = build.run_in(folder.path()).unwrap();
        assert_eq!(module, folder.path().join("swing.rs"));
        folder.path().read_dir().unwrap().count()
    };
    assert_eq!(files(&build), 1);
    assert_eq!(files(&build.manifest()), 2);
    assert!(folder.path().join("swing.json").is_file());
}

#[test]
fn prescribed_joints_are_marked_by_speed() {
    let folder = tempfile::tempdir().unwrap();
    let build = Build::new("tests/models/cart_pole.toml").functions(["hybrid_dynamics"]);
    let module = build.clone().prescribed("pole").run_in(folder.path());
    let text = std::fs::read_to_string(module.unwrap()).unwrap();
    assert!(text.contains("pub const PRESCRIBED: [bool; NU] = [false, true];"));
    let faults = build
        .prescribed("poles")
        .prescribed("cart")
        .prescribed("cart");
    let faults = faults.run_in(folder.path()).unwrap_err().to_string();
    assert_eq!(
        faults,
        "tests/models/cart_pole.toml: `poles` is no joint of the model; did you mean `pole`?; `cart` is named twice; leave one of the two out"
    );
}

#[test]
fn functions_for_c_have_the_name_of_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let build = Build::new("tests/models/pendulum.toml").abi(Abi::C);
    for name in ["pendulum", "swing"] {
        let build = build.clone().name(name);
        build.run_in(folder.path()).unwrap();
        let header = folder.path().join(format!("{name}.h"));
        let header = std::fs::read_to_string(header).unwrap();
        assert!(header.contains(&format!("void {name}_q_dot_f64(")));
    }
}

#[test]
fn names_that_lead_out_of_the_folder_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let build = Build::new("tests/models/pendulum.toml");
    for name in ["", "../swing", "sub/swing", "swing.rs"] {
        let ran = build.clone().name(name).run_in(folder.path());
        let told = format!("{:?}", ran.unwrap_err());
        let expected = format!(
            "the module is called `{name}`; expected a file name, without a folder and without `.rs`: `Build::name` gives it another"
        );
        assert_eq!(told, expected);
    }
    assert_eq!(folder.path().read_dir().unwrap().count(), 0);
    build.name("swing.v2").run_in(folder.path()).unwrap();
    assert!(folder.path().join("swing.v2.rs").is_file());
}

#[test]
fn faults_are_shown_without_the_word_that_rust_writes_before_them() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("arm.toml"), "[[body]]\n").unwrap();
    let ran = Build::new(folder.path().join("arm.toml")).run_in(folder.path());
    let told = format!("{:?}", ran.unwrap_err());
    assert!(told.contains("error: "), "it has several faults: {told}");
    assert!(!told.starts_with("error") && !told.is_empty(), "{told}");
}
