//! Parameters of queries and headers: one table of each type that is read from them. The document
//! shows the table, and the parser takes the names from it.

/// What is read from parameters.
pub(super) trait Parameters {
    /// Their names, in the order of the table.
    const NAMES: &'static [&'static str];
}

/// Declares the parameters of a type by description, name, JSON Schema and example.
macro_rules! parameters {
    ($place:literal, $type:ty {
        $($(#[doc = $line:literal])+ $name:literal: $schema:tt $(, $example:tt)?;)+
    }) => {
        impl $crate::http::parameters::Parameters for $type {
            const NAMES: &'static [&'static str] = &[$($name),+];
        }

        impl utoipa::IntoParams for $type {
            fn into_params(
                _: impl Fn() -> Option<utoipa::openapi::path::ParameterIn>,
            ) -> Vec<utoipa::openapi::path::Parameter> {
                let table = serde_json::json!([$({
                    "name": $name, "in": $place, "required": false,
                    "description": ([$($line),+].map(str::trim).join("\n")),
                    "schema": $schema, $("example": $example,)?
                }),+]);
                serde_json::from_value(table).expect("parameters as OpenAPI has them")
            }
        }
    };
}
pub(super) use parameters;
