//! What the header for C says of a module's names and limits.

use kane_codegen::listing::{Facts, Module};
use kane_codegen::origin::Origin;
use kane_codegen::printers::c;
use kane_codegen::{
    compile,
    functions::ALL,
    options::{Functions, Options},
};
use kane_test_support::models::{build, system};

/// The header of a module of which these facts are others.
fn header(change: impl FnOnce(&mut Facts)) -> String {
    header_of(("two", "[\"s1\"]"), &Options::default(), change)
}

/// The header of a body that turns, with another one.
fn header_of(other: (&str, &str), options: &Options, change: impl FnOnce(&mut Facts)) -> String {
    let text = system("[0, 1]", &[("one", "[\"theta1\"]"), other]);
    header_for(&text, options, change)
}

/// The header of a model.
fn header_for(text: &str, options: &Options, change: impl FnOnce(&mut Facts)) -> String {
    let tree = build(text).expect("a sound description").tree;
    let compiled = compile::compile(&tree, options).expect("functions of every system");
    let origin = Origin::new(&tree, "two.toml", options);
    let mut module = Module::new(&tree, origin, &compiled);
    change(&mut module.facts);
    c::header(&module, "two")
}

#[test]
fn names_are_literals_whatever_they_hold() {
    let header = header(|facts| {
        "left \"foot\"\n".clone_into(&mut facts.bodies[0].name);
        "größe".clone_into(&mut facts.bodies[1].name);
    });
    assert!(header.contains("\"left \\\"foot\\\"\\012\""), "{header}");
    assert!(header.contains("\"gr\\303\\266\\303\\237e\""), "{header}");
}

#[test]
fn body_called_as_a_table_has_another_name() {
    let header = header(|facts| "names".clone_into(&mut facts.bodies[0].identifier));
    assert!(header.contains("TWO_BODY_NAMES_ = 0"), "{header}");
    assert!(header.contains("TWO_BODY_NAMES[TWO_NB]"), "{header}");
}

#[test]
fn body_called_as_the_rest_of_a_table_has_another_name() {
    let header = header(|facts| {
        // The speeds that move the frame of a body that is called `body`.
        facts.sizes.0[0].name = "BODY_SPEEDS".to_owned();
        "speeds".clone_into(&mut facts.bodies[0].identifier);
        "speeds_".clone_into(&mut facts.bodies[1].identifier);
    });
    assert!(header.contains("TWO_BODY_SPEEDS_ = 0"), "{header}");
    assert!(header.contains("TWO_BODY_SPEEDS__ = 1"), "{header}");
}

#[test]
fn numbers_without_bound_are_huge() {
    let header = header(|facts| facts.limits.lower = vec![f64::NEG_INFINITY, 0.1]);
    let start = header.find("LOWER_LIMITS[").expect("the table of limits");
    let table: String = header[start..].chars().take_while(|&c| c != ';').collect();
    let numbers = table.split_once('{').expect("its numbers").1;
    let numbers: Vec<&str> = numbers.split([',', '}']).map(str::trim).collect();
    assert_eq!(numbers[..2], ["-KANE_NO_LIMIT", "0.1"]);
}

#[test]
fn what_is_written_has_the_units_of_the_model() {
    let options = Options::default();
    let lines = |joint| header_of(("two", joint), &options, |_| {});
    let both = lines("[\"s1\"]");
    assert!(both.contains("- `u_dot`: is written, whole: rad/s^2 and m/s^2\n"));
    assert!(both.contains("- `m`: is written, whole: kg m^2, kg m, kg\n"));
    let turning = lines("[\"theta2\"]");
    assert!(turning.contains("- `u_dot`: is written, whole: rad/s^2\n"));
    assert!(turning.contains("- `m`: is written, whole: kg m^2\n"));
    assert!(turning.contains("- `q`: coordinates, rad\n"));
}

#[test]
fn texts_speak_of_names_that_the_header_declares() {
    let asked = [ALL, "bias(sin_cos)", "tau = bias+forcing", "pose(two)"];
    let functions = Functions::of(asked.map(str::to_owned));
    let options = Options {
        functions,
        ..Options::default()
    };
    let header = header_of(("two", "[\"s1\"]"), &options, |_| {});
    let texts = header.lines().filter(|line| line.starts_with("///"));
    // What is asked for and what the user has named stay as they are.
    assert!(!header.contains("request `two_"));
    assert!(!header.contains("`two_tau_f64`, "));
    assert!(!header.contains("this matrix times `two_"));
    let mut n_renamed = 0;
    for piece in texts.flat_map(|line| line.split('`').skip(1).step_by(2)) {
        n_renamed += usize::from(piece.starts_with("two_") || piece.starts_with("TWO_"));
        assert!(!header.contains(&format!(" TWO_{piece}[")), "{piece}");
        assert!(!header.contains(&format!(" TWO_{piece} ")), "{piece}");
        let is_argument = [format!(" {piece}["), format!("*{piece}")];
        let is_argument = is_argument.iter().any(|declared| header.contains(declared));
        let is_function = header.contains(&format!("void two_{piece}_f64("));
        let is_request = header.contains(&format!("request `{piece}`"));
        assert!(is_argument || is_request || !is_function, "{piece}");
    }
    assert!(n_renamed > 20, "{n_renamed}");
}

#[test]
fn frame_called_as_a_function_keeps_its_name_in_texts() {
    let functions = Functions::of(["pose(bias)", "bias", "default"].map(str::to_owned));
    let options = Options {
        functions,
        ..Options::default()
    };
    let header = header_of(("bias", "[\"s1\"]"), &options, |_| {});
    assert!(header.contains("frame `bias`"), "{header}");
    assert!(!header.contains("frame `two_"), "{header}");
    assert!(header.contains("void two_bias_f64("));
}

#[test]
fn every_name_of_the_module_in_the_code_of_a_header_is_one_that_it_declares() {
    let functions = Functions::of([ALL, "bias(sin_cos)", "pose(two)"].map(str::to_owned));
    let options = Options {
        functions,
        ..Options::default()
    };
    let header = header_of(("two", "[\"s1\"]"), &options, |_| {});
    let declared = c::identifiers(&header, "two");
    let code = header.lines().map(|line| line.split("//").next());
    // Between quotes names are those of the model.
    let code = code.flatten().flat_map(|line| line.split('"').step_by(2));
    let is_of_name = |character: char| character.is_ascii_alphanumeric() || character == '_';
    let words = code.flat_map(|line| line.split(|c| !is_of_name(c)));
    let own = words.filter(|word| word.starts_with("two_") || word.starts_with("TWO_"));
    let own: std::collections::BTreeSet<&str> = own.collect();
    assert_eq!(declared, own);
    assert!(own.len() > 200, "{}", own.len());
}

/// The header of a robot with two frames, with these functions.
fn header_with_frames(functions: &[&str]) -> String {
    let fixed = "\"fixed\"";
    let one = ("one", "[\"theta1\", \"s2\"]");
    let text = system("[0, 1, 1]", &[one, ("tool", fixed), ("s", fixed)]);
    let functions = functions.iter().map(|&name| name.to_owned());
    let options = Options {
        functions: Functions::of(functions),
        ..Options::default()
    };
    header_for(&text, &options, |_| {})
}

#[test]
fn every_table_has_its_length_as_a_macro() {
    let header = header_with_frames(&["base_regressor", "partial_velocity"]);
    for table in ["FRAMES", "BASE_PARAMETER_TERMS", "PARTIAL_VELOCITY_BLOCKS"] {
        let declared = format!(" TWO_{table}[TWO_{table}_LEN] = {{\n");
        let (_, rest) = header.split_once(&declared).expect(table);
        let (entries, _) = rest.split_once("\n};").expect(table);
        let length = format!("#define TWO_{table}_LEN {}\n", entries.lines().count());
        assert!(header.contains(&length), "{length}{header}");
    }
    // None of a table that is not there.
    assert!(!header_with_frames(&["bias"]).contains("TERMS_LEN"));
}

#[test]
fn frames_have_an_enumeration_as_bodies_have() {
    let header = header_with_frames(&["bias"]);
    let frames = "enum {\n    TWO_FRAME_TOOL = 0,\n    TWO_FRAME_S = 1\n};\n";
    assert!(header.contains(frames), "{header}");
}

#[test]
fn order_of_inertial_parameters_stands_where_they_are_counted() {
    let header = header_with_frames(&["base_regressor", "regressor_packed", "regressor"]);
    let order = "m, m c_x, m c_y, m c_z, I_xx, I_xy, I_yy, I_xz, I_yz, I_zz";
    for declared in [
        "void two_regressor_f64(",
        "typedef struct kane_base_term {",
        "int TWO_REGRESSOR_PACKED_PLACES[",
    ] {
        let mut sections = header.split("\n\n");
        let section = sections.find(|section| section.contains(declared));
        let section = section.expect(declared).replace('`', "");
        assert!(section.contains(order), "{section}");
    }
}

#[test]
fn linearized_steps_say_how_much_stack_they_take() {
    let header = header_with_frames(&["forward_dynamics+d(forward_dynamics)/d(q, u, tau)"]);
    for matrices in ["some 20 matrices", "some 30 matrices"] {
        let told = format!("{matrices} of `TWO_NU` by `TWO_NU` on the stack.");
        assert!(header.contains(&told), "{header}");
    }
}
