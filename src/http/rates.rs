//! Rate limits: jobs per second that one API key may submit. Queries are never limited.

use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use super::problem::Problem;
use super::problem_type::ProblemType;
use crate::jobs::KeyId;

/// Seconds for which an idle key accumulates jobs that it may submit at once.
const BURST_SECONDS: f64 = 10.0;

/// Most keys remembered. Above it, keys with full buckets are forgotten, which changes nothing for
/// them.
const REMEMBERED: usize = 10_000;

/// A token bucket for each key: it fills at a steady rate, and each job takes one token.
#[derive(Debug)]
pub(super) struct Rates {
    per_second: Option<f64>,
    buckets: Mutex<HashMap<KeyId, (f64, Instant)>>,
}

impl Rates {
    /// `per_second` jobs for each key; `None` is no limit.
    pub(super) fn new(per_second: Option<f64>) -> Self {
        Self { per_second, buckets: Mutex::default() }
    }

    /// Takes one token, or returns the time after which to retry.
    pub(super) fn take(&self, key: Option<KeyId>) -> Result<(), Problem> {
        self.take_at(key, Instant::now()).map_err(|wait| {
            let seconds = u16::try_from(wait.as_secs()).unwrap_or(u16::MAX).saturating_add(1);
            let detail = format!("this API key hands in jobs too fast; try again in {seconds} s");
            Problem::new(ProblemType::TooManyJobs, detail).retry_after(seconds)
        })
    }

    fn take_at(&self, key: Option<KeyId>, now: Instant) -> Result<(), Duration> {
        let (Some(rate), Some(key)) = (self.per_second, key) else { return Ok(()) };
        let full = (rate * BURST_SECONDS).max(1.0);
        let level = |(jobs, since): (f64, Instant)| {
            full.min(jobs + rate * now.saturating_duration_since(since).as_secs_f64())
        };
        let mut buckets = self.buckets.lock().unwrap_or_else(PoisonError::into_inner);
        if buckets.len() >= REMEMBERED {
            buckets.retain(|_, bucket| level(*bucket) < full);
        }
        let bucket = buckets.entry(key).or_insert((full, now));
        let jobs = level(*bucket);
        if jobs < 1.0 {
            *bucket = (jobs, now);
            return Err(Duration::from_secs_f64((1.0 - jobs) / rate));
        }
        *bucket = (jobs - 1.0, now);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_gets_its_rate_and_no_other_suffers() {
        let rates = Rates::new(Some(2.0));
        let (greedy, modest, start) = (KeyId::generate(), KeyId::generate(), Instant::now());
        let taken = (0..100).filter(|_| rates.take_at(Some(greedy), start).is_ok()).count();
        assert_eq!(taken, 20);
        assert_eq!(rates.take_at(Some(greedy), start), Err(Duration::from_millis(500)));
        assert_eq!(rates.take_at(Some(modest), start), Ok(()));
        let later = start + Duration::from_secs(1);
        let taken = (0..100).filter(|_| rates.take_at(Some(greedy), later).is_ok()).count();
        assert_eq!(taken, 2);
        assert_eq!(rates.take_at(None, start), Ok(()));
        assert_eq!(Rates::new(None).take_at(Some(greedy), start), Ok(()));
    }
}
