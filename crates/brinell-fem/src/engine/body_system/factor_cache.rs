//! Bodies and factors kept from one job to the next.

use std::mem;
use std::ops::{Deref, DerefMut};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use crate::engine::body_system::elastic_body::{BodyKey, ElasticBody};
use sparse_cholesky::Cholesky;

/// Elastic bodies by their key, each with the factors that earlier jobs returned.
///
/// A job whose bodies are in the cache needs no new mesh, ordering and analysis, and refactorizes
/// only the changed part of its stiffness. The cache does not change an answer: it is bit for bit
/// that of a job without a cache.
///
/// The bytes held are limited; the least recently used entry is evicted first. Factors that jobs
/// are using do not count.
#[derive(Debug)]
pub struct FactorCache {
    limit: usize,
    state: Mutex<CacheState>,
}

/// Statistics of a cache.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct FactorCacheStats {
    /// Bodies found in the cache.
    pub hits: u64,
    /// Bodies made anew.
    pub misses: u64,
    /// Bytes held.
    pub bytes: usize,
}

#[derive(Debug, Default)]
struct CacheState {
    /// The least recently used entry comes first.
    entries: Vec<Entry>,
    stats: FactorCacheStats,
}

#[derive(Debug)]
struct Entry {
    body: Arc<ElasticBody>,
    /// Factors that no job is using.
    factors: Vec<Cholesky>,
}

impl Entry {
    fn bytes(&self) -> usize {
        self.body.bytes() + self.factors.iter().map(Cholesky::bytes).sum::<usize>()
    }
}

impl FactorCache {
    /// Makes an empty cache with a limit in bytes.
    pub fn new(limit: usize) -> Self {
        Self { limit, state: Mutex::default() }
    }

    /// Returns the statistics.
    pub fn stats(&self) -> FactorCacheStats {
        self.state().stats
    }

    /// Returns the body of a key, if it is in the cache.
    pub(crate) fn find(&self, key: &BodyKey) -> Option<Arc<ElasticBody>> {
        let mut state = self.state();
        let found = state.entries.iter().rposition(|entry| entry.body.key == *key);
        let count = if found.is_some() { &mut state.stats.hits } else { &mut state.stats.misses };
        *count += 1;
        let entry = state.entries.remove(found?);
        let body = Arc::clone(&entry.body);
        state.entries.push(entry);
        Some(body)
    }

    /// The body used last of those that serve.
    pub(crate) fn find_like(
        &self,
        serves: impl Fn(&ElasticBody) -> bool,
    ) -> Option<Arc<ElasticBody>> {
        let bodies: Vec<_> =
            self.state().entries.iter().map(|entry| Arc::clone(&entry.body)).collect();
        bodies.into_iter().rfind(|body| serves(body))
    }

    /// Stores a body, unless its key is present or the body is too large.
    pub(crate) fn keep(&self, body: &Arc<ElasticBody>) {
        self.change(|state| {
            let is_new = state.entries.iter().all(|entry| entry.body.key != body.key);
            if is_new && body.bytes() <= self.limit {
                state.entries.push(Entry { body: Arc::clone(body), factors: Vec::new() });
            }
        });
    }

    /// A factor of this body, ready to be refactored; empty if the cache holds none.
    pub(crate) fn acquire(self: &Arc<Self>, body: &Arc<ElasticBody>) -> PooledFactor {
        let kept = self.change(|state| {
            let entry = state.entries.iter_mut().find(|entry| Arc::ptr_eq(&entry.body, body));
            entry.and_then(|entry| entry.factors.pop())
        });
        let factor = kept.unwrap_or_else(|| Cholesky::empty(&body.symbolic));
        PooledFactor { factor, owner: Some((Arc::clone(self), Arc::clone(body))) }
    }

    /// Stores a factor if its body is in the cache, unless the factor is too large.
    fn release(&self, body: &Arc<ElasticBody>, factor: Cholesky) {
        let surplus = self.change(|state| {
            let entry = state.entries.iter_mut().find(|entry| Arc::ptr_eq(&entry.body, body));
            match entry.filter(|entry| entry.bytes() + factor.bytes() <= self.limit) {
                Some(entry) => {
                    entry.factors.push(factor);
                    None
                }
                None => Some(factor),
            }
        });
        drop(surplus);
    }

    /// Changes what is held, then makes room.
    fn change<T>(&self, work: impl FnOnce(&mut CacheState) -> T) -> T {
        let mut state = self.state();
        let outcome = work(&mut state);
        let mut bytes: usize = state.entries.iter().map(Entry::bytes).sum();
        let mut removed = 0;
        while bytes > self.limit {
            bytes -= state.entries[removed].bytes();
            removed += 1;
        }
        state.stats.bytes = bytes;
        let surplus: Vec<Entry> = state.entries.drain(..removed).collect();
        drop(state);
        // Freeing memory takes milliseconds; the lock is not held meanwhile.
        drop(surplus);
        outcome
    }

    fn state(&self) -> MutexGuard<'_, CacheState> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A factor that a job is using; dropping it returns it to its cache, if it has one.
pub(crate) struct PooledFactor {
    factor: Cholesky,
    owner: Option<(Arc<FactorCache>, Arc<ElasticBody>)>,
}

impl PooledFactor {
    /// A factor that belongs to no cache.
    pub fn own(factor: Cholesky) -> Self {
        Self { factor, owner: None }
    }
}

impl Deref for PooledFactor {
    type Target = Cholesky;

    fn deref(&self) -> &Cholesky {
        &self.factor
    }
}

impl DerefMut for PooledFactor {
    fn deref_mut(&mut self) -> &mut Cholesky {
        &mut self.factor
    }
}

impl Drop for PooledFactor {
    fn drop(&mut self) {
        if let Some((cache, body)) = self.owner.take() {
            let none = Cholesky::empty(&body.symbolic);
            cache.release(&body, mem::replace(&mut self.factor, none));
        }
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use super::*;
    use crate::assembly::Support;
    use crate::engine::Solution;
    use crate::engine::body_system::{elastic_body::tests, preparation};
    use brinell_method::observer::Unobserved;
    use brinell_method::run::Run;

    fn key(radius: f64) -> BodyKey {
        tests::key(radius, 210e3, Support::Clamped)
    }

    fn prepare(radius: f64, cache: Option<&FactorCache>) -> Arc<ElasticBody> {
        let (solution, observer) = (&mut Solution::default(), &mut Unobserved);
        preparation::prepare(
            key(radius),
            None,
            cache,
            &mut Run::new(&mut solution.phases, &mut solution.passes, observer),
        )
        .unwrap()
    }

    #[test]
    fn what_has_not_been_used_for_longest_goes_first() {
        let one = prepare(10.0, None).bytes();
        let cache = FactorCache::new(2 * one + one / 2);
        let first = prepare(10.0, Some(&cache));
        prepare(11.0, Some(&cache));
        assert!(Arc::ptr_eq(&prepare(10.0, Some(&cache)), &first));
        let third = prepare(12.0, Some(&cache));
        assert!(
            Arc::ptr_eq(&third.symbolic, &first.symbolic),
            "radii do not change the structure"
        );
        assert!(cache.find(&key(10.0)).is_some() && cache.find(&key(12.0)).is_some());
        assert!(cache.find(&key(11.0)).is_none());
        assert_eq!(cache.stats(), FactorCacheStats { hits: 3, misses: 4, bytes: 2 * one });
    }

    #[test]
    fn factors_go_from_job_to_job() {
        let cache = Arc::new(FactorCache::new(1 << 20));
        let body = prepare(10.0, Some(&cache));
        let bare = cache.stats().bytes;
        let stiffness = body.stiffness_with(|_| [8e4; 4]);
        let mut factor = cache.acquire(&body);
        factor.refactor(stiffness.clone(), &mut || ControlFlow::Continue(())).unwrap();
        let size = factor.bytes();
        // Another job at the same time gets one of its own.
        assert_eq!(cache.acquire(&body).bytes(), 0);
        assert_eq!(cache.stats().bytes, bare);
        drop(factor);
        assert_eq!(cache.stats().bytes, bare + size);
        let again = cache.acquire(&body);
        assert_eq!((again.bytes(), cache.stats().bytes), (size, bare));
        // A factor whose body was evicted is freed when it is dropped.
        cache.change(|state| state.entries.clear());
        drop(again);
        assert_eq!(cache.stats().bytes, 0);
    }

    #[test]
    fn what_is_too_large_is_not_kept() {
        let one = prepare(10.0, None).bytes();
        let cache = Arc::new(FactorCache::new(one));
        let body = prepare(10.0, Some(&cache));
        assert_eq!(cache.stats().bytes, one);
        let mut factor = cache.acquire(&body);
        factor
            .refactor(body.stiffness_with(|_| [8e4; 4]), &mut || ControlFlow::Continue(()))
            .unwrap();
        drop(factor);
        assert_eq!(cache.stats().bytes, one);
        assert!(cache.find(&key(10.0)).is_some());
        let smaller = FactorCache::new(one - 1);
        prepare(10.0, Some(&smaller));
        assert_eq!(smaller.stats().bytes, 0);
    }
}
