//! The circular cylinder.

use crate::job::fields::{Field, record};
use crate::job::{PositiveF64, Quantity};

record! {
    /// Half a cylinder, a sphere in axisymmetry, held at its diametral plane.
    #[derive(Copy)]
    pub struct Cylinder("cylinder", "Cylinder") {
        /// Radius.
        pub radius: PositiveF64 = Field::quantity(Quantity::Length).label("Radius", "R").example(20.0),
    }
}
