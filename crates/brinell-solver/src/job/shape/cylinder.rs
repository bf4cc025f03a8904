//! The circular cylinder.

use crate::job::fields::{Field, record};
use crate::job::{Domain, PositiveF64};

record! {
    /// Half a cylinder, held at its diametral plane. In axisymmetry it is read as a `sphere`.
    #[derive(Copy)]
    pub struct Cylinder("cylinder", "Cylinder") {
        /// Radius.
        pub radius: PositiveF64 = Field::quantity(Domain::Length).label("Radius", "R").example(20.0),
    }
}
