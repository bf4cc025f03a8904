//! The source of the elastic bodies of a job: the other body of the job, the cache, or a new mesh.

use std::sync::Arc;

use super::elastic_body::{BodyKey, ElasticBody};
use super::factor_cache::FactorCache;
use crate::engine::error::MeshedError;
use brinell_method::phases::Phase;
use brinell_method::run::Run;

/// Meshes a body, orders and analyses its equations and assembles its stiffness, unless the other
/// body of the job or the cache has it already.
pub(crate) fn prepare(
    key: BodyKey,
    other: Option<&Arc<ElasticBody>>,
    cache: Option<&FactorCache>,
    run: &mut Run<'_>,
) -> Result<Arc<ElasticBody>, MeshedError> {
    if let Some(body) = other.filter(|other| other.key == key) {
        return Ok(Arc::clone(body));
    }
    let find = |cache: &FactorCache| run.time(Phase::Mesh, || cache.find(&key));
    if let Some(body) = cache.and_then(find) {
        return Ok(body);
    }
    let like = |serves: &dyn Fn(&ElasticBody) -> bool| {
        let body = other.filter(|other| serves(other)).cloned();
        body.or_else(|| cache?.find_like(serves))
    };
    let body = Arc::new(ElasticBody::new(key, like, run)?);
    if let Some(cache) = cache {
        run.time(Phase::Mesh, || cache.keep(&body));
    }
    Ok(body)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::Support;
    use crate::engine::Solution;
    use crate::engine::body_system::elastic_body::tests::key;
    use brinell_method::observer::Unobserved;

    fn cylinder(
        radius: f64,
        young: f64,
        support: Support,
        other: Option<&Arc<ElasticBody>>,
    ) -> Arc<ElasticBody> {
        let (solution, observer) = (&mut Solution::default(), &mut Unobserved);
        let key = key(radius, young, support);
        prepare(
            key,
            other,
            None,
            &mut Run::new(&mut solution.phases, &mut solution.passes, observer),
        )
        .unwrap()
    }

    #[test]
    fn an_equal_plan_needs_nothing_new() {
        let body = cylinder(20.0, 210e3, Support::Clamped, None);
        assert!(Arc::ptr_eq(&body, &cylinder(20.0, 210e3, Support::Clamped, Some(&body))));
        assert!(!Arc::ptr_eq(&body, &cylinder(20.0, 70e3, Support::Clamped, Some(&body))));
    }

    #[test]
    fn another_material_or_size_needs_no_other_analysis() {
        let body = cylinder(20.0, 210e3, Support::Clamped, None);
        let shares = |radius: f64, young: f64, support: Support| {
            let other = cylinder(radius, young, support, Some(&body));
            Arc::ptr_eq(&other.symbolic, &body.symbolic)
                && Arc::ptr_eq(&other.equations, &body.equations)
        };
        assert!(shares(20.0, 70e3, Support::Clamped) && shares(40.0, 210e3, Support::Clamped));
        assert!(!shares(20.0, 210e3, Support::Roller));
    }
}
