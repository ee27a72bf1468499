//! Lines of documentation that say facts.

use kane_codegen::listing::{Counted, nominal, read_nominal};
use kane_codegen::program::Operations;
use kane_codegen::tree::Parameter;

#[test]
fn lines_are_read_as_they_were_written() {
    for formulation in [None, Some("notes".to_owned())] {
        let counted = Counted {
            operations: Operations {
                mul: 4,
                add: 3,
                div: 2,
                trig: 1,
            },
            formulation,
        };
        assert_eq!(Counted::read(&counted.line()), Some(counted));
    }
    let parameter = Parameter {
        name: "hub_mass".to_owned(),
        body: None,
        nominal: 12.0,
        unit: "kg",
    };
    assert_eq!(read_nominal(&nominal(&parameter)), Some("12.0 kg"));
}
