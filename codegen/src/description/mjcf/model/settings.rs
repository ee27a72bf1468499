//! `compiler` and `option`: what holds for the whole model.

use crate::description::mjcf::files::Files;
use crate::description::mjcf::files::paths::is_absolute;
use crate::description::mjcf::known;
use crate::description::mjcf::left_out::{advice, left_out};
use crate::description::mjcf::model::angles::{AngleUnit, EulerAxis, XYZ};
use crate::description::mjcf::model::attributes::Attributes;
use crate::description::xml::{Element, Reader};
use crate::description::{LeftOut, Reading};
use crate::diagnostic::{Diagnostic, Span, Spanned, shown};

/// What holds for the whole model.
#[derive(Debug)]
pub(in crate::description::mjcf) struct Settings {
    pub(in crate::description::mjcf) angle: AngleUnit,
    pub(in crate::description::mjcf) euler: [EulerAxis; 3],
    /// Whether a range makes a limit.
    pub(in crate::description::mjcf) auto_limits: Switch,
    pub(in crate::description::mjcf) from_geoms: FromGeoms,
    /// Groups of the geoms that count for inertias, the first and the last.
    pub(in crate::description::mjcf) groups: [f64; 2],
    pub(in crate::description::mjcf) least_mass: Option<Spanned<f64>>,
    pub(in crate::description::mjcf) least_inertia: Option<Spanned<f64>>,
    /// Whether moments that no body can have are replaced by their mean.
    pub(in crate::description::mjcf) balance: Switch,
    /// What the masses of all bodies are scaled to.
    pub(in crate::description::mjcf) total_mass: Option<f64>,
    /// Where it says that bodies without joints become part of those that carry them.
    pub(in crate::description::mjcf) fuse: Option<Span>,
    /// Whether meshes without a word about it are filled exactly, as in MuJoCo 3.
    pub(in crate::description::mjcf) exact_meshes: Switch,
    /// Whether floating bodies get the axes of their inertia.
    pub(in crate::description::mjcf) align_free: Switch,
    /// The folder of mesh files, beside the model's own; empty where they stand beside the model.
    pub(in crate::description::mjcf) mesh_folder: String,
    /// Whether folders in the names of files are left out.
    pub(in crate::description::mjcf) strip_path: Switch,
    /// Whether shapes that stand for meshes are as large as these, not as their inertia.
    pub(in crate::description::mjcf) fit_bounds: Switch,
    /// In inertial components, m/s².
    pub(in crate::description::mjcf) gravity: [Spanned<f64>; 3],
    pub(in crate::description::mjcf) springs: Switch,
    pub(in crate::description::mjcf) dampers: Switch,
    pub(in crate::description::mjcf) equalities: Switch,
    /// Where it says that options of attached models count.
    pub(in crate::description::mjcf) merges: Option<Span>,
}

impl Settings {
    /// Takes over what holds for all from the model to which this one is attached; `folder` is that of this one.
    pub(in crate::description::mjcf) fn attach_to(&mut self, main: &Self, folder: &str) {
        self.gravity = main.gravity;
        self.total_mass = main.total_mass;
        self.springs = main.springs;
        self.dampers = main.dampers;
        self.equalities = main.equalities;
        self.strip_path = main.strip_path;
        self.fit_bounds = main.fit_bounds;
        if !folder.is_empty() && !is_absolute(&self.mesh_folder) {
            self.mesh_folder = format!("{folder}/{}", self.mesh_folder);
        }
    }
}

/// Whether something is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::description::mjcf) enum Switch {
    On,
    Off,
}

/// When inertias come from geoms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::description::mjcf) enum FromGeoms {
    /// Where a body has no `inertial`.
    Auto,
    Always,
    Never,
}

/// The words for a switch.
pub(in crate::description::mjcf) const TRUTH: [(&str, Switch); 2] =
    [("true", Switch::On), ("false", Switch::Off)];
const ENABLED: [(&str, Switch); 2] = [("enable", Switch::On), ("disable", Switch::Off)];

/// Reads the sections `compiler` and `option`, of which there may be several; the last word counts.
pub(in crate::description::mjcf) fn read<'d>(
    reader: &mut Reader,
    files: &'d Files<'_>,
    compilers: &[Element<'d>],
    options: &[Element<'d>],
    root: Span,
    reading: &Reading,
) -> Settings {
    let mut settings = Settings {
        angle: AngleUnit::Degree,
        euler: XYZ,
        auto_limits: Switch::On,
        from_geoms: FromGeoms::Auto,
        groups: [0.0, 5.0],
        least_mass: None,
        least_inertia: None,
        balance: Switch::Off,
        total_mass: None,
        fuse: None,
        exact_meshes: Switch::Off,
        align_free: Switch::Off,
        mesh_folder: String::new(),
        strip_path: Switch::Off,
        fit_bounds: Switch::Off,
        gravity: [0.0, 0.0, -9.81].map(|g| Spanned::new(g, root)),
        springs: Switch::On,
        dampers: Switch::On,
        equalities: Switch::On,
        merges: None,
    };
    for element in compilers {
        let attributes = Attributes::of(reader, *element, "`compiler`", &known::COMPILER);
        compiler(reader, &attributes, &mut settings);
        for child in files.children(*element) {
            if child.name() != "lengthrange" {
                reader.unknown_child(child, "`compiler`", &[]);
            }
        }
    }
    let mut gravity = Switch::On;
    for element in options {
        let attributes = Attributes::of(reader, *element, "`option`", &known::OPTION);
        option(reader, &attributes, &mut settings, reading);
        for child in files.children(*element) {
            reader.unknown_child(child, "`option`", &["flag"]);
            if child.name() == "flag" {
                let attributes = Attributes::of(reader, child, "`flag`", &known::FLAG);
                flag(reader, &attributes, &mut settings);
                let found = attributes.keyword(reader, "gravity", &ENABLED);
                gravity = found.map_or(gravity, |found| found.value);
            }
        }
    }
    if gravity == Switch::Off {
        settings.gravity = settings.gravity.map(|g| Spanned::new(0.0, g.span));
    }
    settings
}

/// Takes over what is given.
fn take<T>(place: &mut T, given: Option<Spanned<T>>) {
    if let Some(given) = given {
        *place = given.value;
    }
}

fn compiler(reader: &mut Reader, attributes: &Attributes<'_>, settings: &mut Settings) {
    let units = [("degree", AngleUnit::Degree), ("radian", AngleUnit::Radian)];
    let from_geoms = [
        ("auto", FromGeoms::Auto),
        ("true", FromGeoms::Always),
        ("false", FromGeoms::Never),
    ];
    take(
        &mut settings.angle,
        attributes.keyword(reader, "angle", &units),
    );
    take(
        &mut settings.from_geoms,
        attributes.keyword(reader, "inertiafromgeom", &from_geoms),
    );
    let switches = [
        ("autolimits", &mut settings.auto_limits),
        ("balanceinertia", &mut settings.balance),
        ("alignfree", &mut settings.align_free),
        ("strippath", &mut settings.strip_path),
        ("fitaabb", &mut settings.fit_bounds),
        ("exactmeshinertia", &mut settings.exact_meshes),
    ];
    for (name, switch) in switches {
        take(switch, attributes.keyword(reader, name, &TRUTH));
    }
    if let Some(least) = attributes.number(reader, "boundmass") {
        settings.least_mass = Some(least).filter(|least| least.value > 0.0);
    }
    if let Some(groups) = attributes.vector(reader, "inertiagrouprange") {
        settings.groups = groups;
    }
    if let Some(least) = attributes.number(reader, "boundinertia") {
        settings.least_inertia = Some(least).filter(|least| least.value > 0.0);
    }
    if let Some(total) = attributes.number(reader, "settotalmass") {
        settings.total_mass = Some(total.value).filter(|total| *total > 0.0);
    }
    if let Some(fuse) = attributes.keyword(reader, "fusestatic", &TRUTH) {
        settings.fuse = (fuse.value == Switch::On).then_some(fuse.span);
    }
    let coordinates = [("local", Switch::Off), ("global", Switch::On)];
    if let Some(global) = attributes.keyword(reader, "coordinate", &coordinates)
        && global.value == Switch::On
    {
        let message = "`coordinate` of `compiler` is `global`; expected `local`";
        let fault = Diagnostic::error(message).at(global.span, "not supported");
        reader.faults.push(
            fault.help(
                "MuJoCo 2.3.3 and older can load such a model and save it in local coordinates",
            ),
        );
    }
    let words = [("warning", false), ("error", false), ("merge", true)];
    if let Some(conflict) = attributes.keyword(reader, "conflict", &words) {
        settings.merges = conflict.value.then_some(conflict.span);
    }
    euler_sequence(reader, attributes, settings);
    // The second one is for meshes alone.
    for name in ["assetdir", "meshdir"] {
        if let Some(folder) = attributes.text(name) {
            folder.value.clone_into(&mut settings.mesh_folder);
        }
    }
}

fn euler_sequence(reader: &mut Reader, attributes: &Attributes<'_>, settings: &mut Settings) {
    let Some(sequence) = attributes.text("eulerseq") else {
        return;
    };
    let axes: Option<Vec<EulerAxis>> = sequence.value.chars().map(EulerAxis::letter).collect();
    if let Some(Ok(axes)) = axes.map(<[EulerAxis; 3]>::try_from) {
        settings.euler = axes;
        return;
    }
    let message = format!(
        "`eulerseq` of `compiler` is `{}`; expected three letters of `x`, `y`, `z`, `X`, `Y`, `Z`",
        shown(sequence.value)
    );
    let fault = Diagnostic::error(message).at(sequence.span, "expected three axes");
    reader.faults.push(fault);
}

fn option(
    reader: &mut Reader,
    attributes: &Attributes<'_>,
    settings: &mut Settings,
    reading: &Reading,
) {
    if let Some(gravity) = attributes.numbers(reader, "gravity") {
        settings.gravity = gravity;
    }
    for name in ["density", "viscosity"] {
        let value = attributes.number(reader, name);
        let Some(value) = value.filter(|value| value.value != 0.0) else {
            continue;
        };
        if reading.leaves_out(LeftOut::Fluid) {
            let message = format!("`{name}` of `option` is left out, with the forces of the fluid");
            left_out(
                reader,
                message,
                value.span,
                ("properties of fluids that are left out", name),
            );
        } else {
            let message = format!(
                "`{name}` of `option` is {}; expected 0, for forces of a fluid are not supported",
                value.value
            );
            let fault = Diagnostic::error(message).at(value.span, "not supported");
            reader
                .faults
                .push(fault.help(advice(LeftOut::Fluid.name())));
        }
    }
}

fn flag(reader: &mut Reader, attributes: &Attributes<'_>, settings: &mut Settings) {
    // `passive` stood for both until MuJoCo 3.3.
    for name in ["passive", "spring"] {
        take(
            &mut settings.springs,
            attributes.keyword(reader, name, &ENABLED),
        );
    }
    for name in ["passive", "damper"] {
        take(
            &mut settings.dampers,
            attributes.keyword(reader, name, &ENABLED),
        );
    }
    for name in ["constraint", "equality"] {
        take(
            &mut settings.equalities,
            attributes.keyword(reader, name, &ENABLED),
        );
    }
}
