//! How large contact and plastic zone are expected to be, and what a mesh of that size costs.

pub(crate) mod contact_size;
pub(crate) mod end_of_contact;
pub(crate) mod estimate;
pub(crate) mod first_contact;
pub(crate) mod rough;
pub(crate) mod trace;
