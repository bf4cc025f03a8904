//! The final state, checked afresh, and what is handed over of it.

pub(crate) mod contact_stiffness;
pub(crate) mod solution;
