//! The theory of plasticity of jobs that verify something else.

use serde_json::{Value, json};

/// Returns a job whose contact is verified by deformation theory, which costs a third of flow
/// theory, unless it names its theory or has a load that only flow theory knows.
pub fn by_deformation_theory(job: &Value) -> Value {
    let mut job = job.clone();
    let needs_flow = ["hardness", "rolling"].iter().any(|load| job["load"].get(load).is_some());
    if job.is_object() && !needs_flow && job["solver"].get("theory").is_none() {
        job["solver"]["theory"] = json!("deformation");
    }
    job
}
