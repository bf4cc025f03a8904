//! Schemas of an OpenAPI document, as a validator that others have written.

use serde_json::Value;

/// The only document there is.
const DOCUMENT: &str = "file:///openapi.json";

/// One schema with what it refers to.
pub struct Schema {
    all: boon::Schemas,
    index: boon::SchemaIndex,
}

impl Schema {
    /// The component of that name.
    #[allow(dead_code, reason = "shared by several test programs")]
    #[track_caller]
    pub fn named(document: &Value, name: &str) -> Self {
        Self::at(document, &format!("/components/schemas/{name}"))
    }

    /// The schema at this pointer. It has to be one.
    #[track_caller]
    pub fn at(document: &Value, pointer: &str) -> Self {
        let mut compiler = boon::Compiler::new();
        let mut all = boon::Schemas::new();
        let added = compiler.add_resource(DOCUMENT, document.clone());
        assert!(added.is_ok(), "{DOCUMENT} is an address");
        match compiler.compile(&format!("{DOCUMENT}#{pointer}"), &mut all) {
            Ok(index) => Self { all, index },
            Err(error) => panic!("{pointer} is no schema: {error:#}"),
        }
    }

    /// Where and why this value does not fit, if so.
    pub fn faults(&self, value: &Value) -> Option<String> {
        self.all.validate(value, self.index).err().map(|error| error.to_string())
    }
}
