//! References to the schemas of the document.

use utoipa::openapi::schema::Schema;
use utoipa::openapi::{Ref, RefOr};

/// Path of the schemas within the document.
pub(super) const BASE: &str = "#/components/schemas/";

/// A schema of this document, for types that are declared elsewhere.
pub(in crate::http) fn named(name: &str) -> RefOr<Schema> {
    RefOr::Ref(Ref::from_schema_name(name))
}

/// A job.
pub(in crate::http) fn job() -> RefOr<Schema> {
    named("ContactJob")
}

/// Units of figures.
pub(in crate::http) fn units() -> RefOr<Schema> {
    named("Units")
}

/// Labels.
pub(in crate::http) fn tags() -> RefOr<Schema> {
    named("Tags")
}
