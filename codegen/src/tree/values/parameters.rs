//! The values that are set at run time, listed as they are met.

use crate::description::{Given, INERTIA_COMPONENTS, Scalar};
use crate::id::{BodyId, ParameterId};
use crate::taken::Taken;
use crate::tree::body::Inertia;
use crate::tree::value::{Parameter, Value};

/// The runtime values met so far.
#[derive(Default)]
pub(crate) struct Parameters {
    pub(crate) list: Vec<Parameter>,
    taken: Taken,
}

impl Parameters {
    pub(crate) fn value(
        &mut self,
        given: Given<Scalar>,
        name: String,
        body: Option<BodyId>,
        unit: &'static str,
    ) -> Option<Value> {
        Some(match given?.value {
            Scalar::Baked(number) => Value::Baked(number),
            Scalar::Runtime(nominal) => {
                self.list.push(Parameter {
                    name: self.taken.take(name),
                    body,
                    nominal,
                    unit,
                });
                Value::Runtime(ParameterId::new(self.list.len() - 1))
            }
        })
    }

    pub(crate) fn vector(
        &mut self,
        given: &[Given<Scalar>; 3],
        name: &str,
        body: Option<BodyId>,
        unit: &'static str,
    ) -> Option<[Value; 3]> {
        let [x, y, z] = given;
        Some([
            self.value(*x, format!("{name}_x"), body, unit)?,
            self.value(*y, format!("{name}_y"), body, unit)?,
            self.value(*z, format!("{name}_z"), body, unit)?,
        ])
    }

    pub(crate) fn inertia(
        &mut self,
        given: &[Given<Scalar>; 6],
        name: &str,
        body: Option<BodyId>,
    ) -> Option<Inertia> {
        let mut components = [Value::Baked(0.0); 6];
        for (index, component) in components.iter_mut().enumerate() {
            *component = self.value(
                given[index],
                format!("{name}_{}", INERTIA_COMPONENTS[index]),
                body,
                "kg m^2",
            )?;
        }
        let [xx, yy, zz, xy, xz, yz] = components;
        Some(Inertia {
            xx,
            yy,
            zz,
            xy,
            xz,
            yz,
        })
    }
}
