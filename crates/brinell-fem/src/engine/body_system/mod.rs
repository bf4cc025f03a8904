//! The discretized pair of bodies: meshes, factors, plastic regions, and the contact between them.

pub(crate) mod axis;
pub(crate) mod body;
mod contact;
pub(crate) mod contact_patch;
pub(crate) mod elastic_body;
pub(crate) mod factor_cache;
pub(crate) mod plastic_search_region;
mod preparation;
mod secant_bodies;
pub(crate) mod system;
pub(crate) mod transfer;
