//! What is kept from job to job changes no answer.

use std::sync::Arc;
use std::thread;

use brinell_solver::solver::{FactorCache, Options, Solution};
use serde_json::{Value, json};

use crate::problems::{bits, paper, solve, solve_with, two_cylinders};

fn bilinear(yield_stress: f64, tangent_modulus: f64) -> Value {
    json!({"law": "bilinear", "yield_stress": yield_stress, "tangent_modulus": tangent_modulus})
}

fn with_elements(mut job: Value, elements: u32) -> Value {
    job["mesh"] = json!({"elements_per_half_width": elements});
    job
}

fn cached(job: &Value, cache: &Arc<FactorCache>) -> Solution {
    solve_with(job, Options { cache: Some(cache), ..Options::default() })
}

#[test]
#[ignore = "full"]
fn a_kept_factor_gives_the_same_bits() {
    let sweep = |forces: [f64; 3]| {
        let mut job = two_cylinders("roller", bilinear(450.0, 5000.0), 1.0);
        job["load"] = json!({"forces": forces});
        job
    };
    let unlike = {
        let mut job = paper(612.6106, "accelerated");
        job["lower"]["material"]["plasticity"] = bilinear(700.0, 2000.0);
        job
    };
    let jobs = [
        paper(612.6106, "accelerated"),
        two_cylinders("clamped", bilinear(480.0, 9000.0), 612.6106),
        unlike,
        paper(612.6106, "strong"),
        paper(612.6106, "weak"),
        paper(612.6106, "secant_stiffness"),
        sweep([200.0, 500.0, 900.0]),
        sweep([900.0, 500.0, 200.0]),
    ]
    .map(|job| with_elements(job, 10));
    let cache = Arc::new(FactorCache::new(256 << 20));
    let alone: Vec<Vec<u64>> = jobs.iter().map(|job| bits(&solve(job))).collect();
    for round in 0..2 {
        for (job, expected) in jobs.iter().zip(&alone) {
            assert_eq!(&bits(&cached(job, &cache)), expected, "round {round}: {job}");
        }
    }
    let before = cache.stats();
    assert!(before.hits > before.misses, "{before:?}");
    let passes = cached(&jobs[0], &cache).passes as u64;
    let after = cache.stats();
    assert_eq!(
        (after.misses, after.hits),
        (before.misses, before.hits + passes),
        "one for each mesh"
    );
}

#[test]
fn bodies_with_equal_contacts_share_meshes() {
    let cache = Arc::new(FactorCache::new(256 << 20));
    let force = 100.0;
    for yield_stress in [440.0, 460.0, 480.0, 500.0, 520.0] {
        for tangent_modulus in [4000.0, 6000.0] {
            // Nothing yields.
            let law = bilinear(yield_stress, tangent_modulus);
            cached(&with_elements(two_cylinders("clamped", law, force), 10), &cache);
        }
    }
    assert_eq!(cache.stats().misses, 3, "sizing, coarse and fine mesh");
    // Other loads and supports do not.
    for job in [
        two_cylinders("clamped", bilinear(500.0, 10000.0), 1.01 * force),
        two_cylinders("roller", bilinear(500.0, 10000.0), force),
    ] {
        let misses = cache.stats().misses;
        cached(&with_elements(job, 10), &cache);
        assert_eq!(cache.stats().misses, misses + 3);
    }
}

#[test]
fn a_small_cache_stays_small() {
    let limit = 2 << 20;
    let cache = Arc::new(FactorCache::new(limit));
    for force in [300.0, 500.0, 700.0, 900.0] {
        let job = with_elements(paper(force, "accelerated"), 8);
        assert_eq!(bits(&cached(&job, &cache)), bits(&solve(&job)));
        let bytes = cache.stats().bytes;
        assert!(bytes > 0 && bytes <= limit, "{bytes}");
    }
    let nothing = Arc::new(FactorCache::new(0));
    cached(&with_elements(paper(300.0, "accelerated"), 5), &nothing);
    assert_eq!(nothing.stats().bytes, 0);
}

#[test]
fn jobs_on_several_threads_share_a_cache() {
    let cache = Arc::new(FactorCache::new(64 << 20));
    let jobs: Vec<Value> = (0..12u32)
        .map(|k| {
            let law = bilinear(450.0 + 10.0 * f64::from(k % 4), 8000.0);
            with_elements(two_cylinders("clamped", law, 612.6106), 6)
        })
        .collect();
    let alone: Vec<Vec<u64>> = jobs.iter().map(|job| bits(&solve(job))).collect();
    thread::scope(|scope| {
        for part in 0..3 {
            let (cache, jobs, alone) = (&cache, &jobs, &alone);
            scope.spawn(move || {
                for k in 0..jobs.len() {
                    let k = (k + 4 * part) % jobs.len();
                    assert_eq!(bits(&cached(&jobs[k], cache)), alone[k]);
                }
            });
        }
    });
}
