//! The rectangular block.

use crate::job::fields::{Field, record};
use crate::job::{Domain, PositiveF64};

record! {
    /// A rectangle, held at its base.
    #[derive(Copy)]
    pub struct Block("block", "Block") {
        /// Full width, centred on the contact.
        pub width: PositiveF64 = Field::quantity(Domain::Length).label("Width", "w").example(200.0),
        /// Height of the rectangle below the contact.
        pub depth: PositiveF64 = Field::quantity(Domain::Length).label("Depth", "d").example(200.0),
    }
}
