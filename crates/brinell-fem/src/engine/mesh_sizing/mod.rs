//! Expected sizes of contact and plastic region, and the cost of a mesh of that size.

pub(crate) mod contact_size;
pub(crate) mod end_of_contact;
pub(crate) mod estimate;
pub(crate) mod first_contact;
pub(crate) mod first_force;
pub(crate) mod rough;
pub(crate) mod trace;
