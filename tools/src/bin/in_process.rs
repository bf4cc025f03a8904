//! Measures how many jobs a second these cores solve without a service: `brinell solve` in a loop,
//! on one thread for each core, with a shared factor cache as in the service.
//! `scripts/throughput.py` compares the service with it.
//!
//! usage: `cargo run --release -p brinell-tools --features service --bin in_process -- JOB.json
//! SECONDS`

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread::{available_parallelism, scope};
use std::time::{Duration, Instant};

use brinell::jobs::encode;
use brinell_solver::job::Job;
use brinell_solver::report;
use brinell_solver::solver::{FactorCache, Options, Unobserved};
use mimalloc::MiMalloc;

/// As in the program.
#[global_allocator]
static ALLOCATOR: MiMalloc = MiMalloc;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut args = std::env::args().skip(1);
    let path = args.next().ok_or("which job?")?;
    let seconds: f64 = args.next().ok_or("for how many seconds?")?.parse()?;
    let text = std::fs::read(path)?;
    report::run(&Job::from_json(&text)?, &mut Unobserved)?;

    let cache = Arc::new(FactorCache::new(512 << 20));
    let (solved, threads) = (AtomicU64::new(0), available_parallelism()?.get());
    let clock = Instant::now();
    let end = clock + Duration::from_secs_f64(seconds);
    scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while Instant::now() < end && answer(&text, &cache) {
                    solved.fetch_add(1, Ordering::Relaxed);
                }
            });
        }
    });
    println!("{:.1}", solved.into_inner() as f64 / clock.elapsed().as_secs_f64());
    Ok(())
}

/// From the text of a job to that of its result.
fn answer(text: &[u8], cache: &Arc<FactorCache>) -> bool {
    let options = Options { cache: Some(cache), ..Options::default() };
    let report = Job::from_json(text).ok();
    let report = report.and_then(|job| report::run_with(&job, options, &mut Unobserved).ok());
    report.is_some_and(|report| encode(&report).is_ok())
}
