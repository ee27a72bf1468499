//! Whose a line of generated text is.

#![expect(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use kane_codegen::functions::CATALOGUE;

/// The bodies of a module, that of each speed, and that of each entry of a packed mass matrix and of a packed regressor.
pub(crate) struct Names {
    bodies: Vec<String>,
    of_speeds: Vec<usize>,
    of_entries: Vec<usize>,
    of_columns: Vec<usize>,
}

impl Names {
    pub(crate) fn of(module: &str) -> Self {
        let table = |name: &str| {
            let start = module.find(&format!("pub const {name}: ")).unwrap();
            let list = module[start..]
                .split_once(" = ")
                .unwrap()
                .1
                .trim_start_matches(['&', '['])
                .split_once("];")
                .unwrap()
                .0;
            let items = list
                .split(',')
                .map(|item| item.trim().trim_matches(['"', '[', ']']).to_owned());
            items.filter(|item| !item.is_empty()).collect::<Vec<_>>()
        };
        let numbers = |name: &str| -> Vec<usize> {
            let items = table(name);
            items.iter().map(|item| item.parse().unwrap()).collect()
        };
        let of_speeds = numbers("SPEED_BODIES");
        // Of row and column the row is the later speed.
        let places = numbers("MASS_MATRIX_PACKED_PLACES");
        let of_entries = places.chunks(2).map(|place| of_speeds[place[0]]);
        let places = numbers("REGRESSOR_PACKED_PLACES");
        let of_columns = places.chunks(2).map(|place| place[1] / 10);
        Self {
            bodies: table("BODY_NAMES"),
            of_entries: of_entries.collect(),
            of_columns: of_columns.collect(),
            of_speeds,
        }
    }

    /// The body that a name begins with; `system` for what is of the whole.
    fn body(&self, name: &str) -> Option<&str> {
        let bodies = self.bodies.iter().map(String::as_str).chain(["system"]);
        let longest = bodies.filter(|body| name.starts_with(&format!("{body}_")));
        longest.max_by_key(|body| body.len())
    }

    /// The body that a statement belongs to: that of the value it declares, assigns or stores, or of the field.
    pub(crate) fn body_of(&self, statement: &str) -> Option<&str> {
        if let Some(rest) = statement.strip_prefix("let ") {
            if rest.starts_with("(sines") {
                // All angles stand together.
                return Some("system");
            }
            return self.body(
                rest.trim_start_matches(['(', ' '])
                    .trim_start_matches("_, "),
            );
        }
        if let Some((target, value)) = statement.split_once(" = ") {
            if !target.contains(['[', '*']) {
                return self.body(target);
            }
            if value.starts_with("R::from_f64(") {
                // A number that is stored belongs to the last body whose speed its place names, or to the body itself.
                let places: Vec<usize> = target
                    .split(['[', ']'])
                    .filter_map(|part| part.parse().ok())
                    .collect();
                let body = match target.split('[').next()? {
                    "columns" => return None,
                    "entries" => *self.of_entries.get(places[0])?,
                    "rotations" | "distances" | "positions" | "velocities" | "alpha" | "rates"
                    | "w_rel" | "energies" | "force" | "moment" => places[0],
                    // A vector of the system, or a column for each speed.
                    "linear" | "angular" | "jacobian" | "position" | "velocity" => {
                        let Some(speed) = places.get(1) else {
                            return Some("system");
                        };
                        *self.of_speeds.get(*speed)?
                    }
                    "y" if places.len() == 3 => places[1],
                    "y" if places.len() == 1 => *self.of_columns.get(places[0])?,
                    "y" => *self.of_speeds.get(places[0])?,
                    _ => *self.of_speeds.get(*places.iter().max()?)?,
                };
                return self.bodies.get(body).map(String::as_str);
            }
            // A value that is stored is a body's, or one of `Prepared`'s.
            return self.body_of(&format!(
                "{},",
                value.trim_start_matches('-').trim_end_matches(';')
            ));
        }
        let field = statement
            .trim_start_matches("pub ")
            .trim_start_matches("p.");
        let functions = CATALOGUE
            .iter()
            .map(|function| format!("{}_", function.name));
        let prefix = functions
            .filter(|prefix| field.starts_with(prefix))
            .max_by_key(String::len);
        self.body(&field[prefix.map_or(0, |prefix| prefix.len())..])
    }
}

/// `place = value;` for a store that stays apart.
pub(crate) fn as_assignment(statement: &str) -> String {
    let stored = statement.strip_prefix("kane::store(&mut ");
    let stored = stored.and_then(|rest| rest.strip_suffix(");")?.split_once(", "));
    stored.map_or_else(
        || statement.to_owned(),
        |(place, value)| format!("{place} = {value};"),
    )
}
