//! Reading of the fields of a step part by part: a slow client occupies the memory of one part,
//! and no connection to the database.

use std::ops::{Deref, Range};

use bytes::Bytes;

use super::{FieldsPart, JobId, JobStore, StoreError};
use brinell_solver::report::{FieldArraysError, FieldLayout};

/// Reads the fields of a step, best from its beginning to its end.
#[derive(Clone)]
pub struct FieldsReader<S> {
    store: S,
    job: JobId,
    step: usize,
    layout: FieldLayout,
    part: FieldsPart,
}

impl<S: Deref<Target: JobStore>> FieldsReader<S> {
    /// Opens the fields of a step (counted from 0); `None` if the job did not ask for fields.
    ///
    /// # Errors
    /// [`StoreError`].
    pub async fn open(store: S, job: JobId, step: usize) -> Result<Option<Self>, StoreError> {
        let Some(part) = store.fields(job, step, 0).await? else { return Ok(None) };
        let layout = FieldLayout::read(&part.bytes).map_err(damaged)?;
        Ok(Some(Self { store, job, step, layout, part }))
    }

    /// Returns the layout of the arrays.
    pub fn layout(&self) -> &FieldLayout {
        &self.layout
    }

    /// Returns the bytes in a range.
    ///
    /// # Errors
    /// [`StoreError`].
    pub async fn bytes(&mut self, range: Range<usize>) -> Result<Bytes, StoreError> {
        let mut gathered = Vec::new();
        while gathered.len() < range.len() {
            let at = range.start + gathered.len();
            if !self.part.has(at) {
                let next = self.store.fields(self.job, self.step, at).await?;
                self.part = next.filter(|part| part.has(at)).ok_or_else(cut_off)?;
            }
            let end = self.part.bytes.len().min(range.end - self.part.first);
            let here = self.part.bytes.slice(at - self.part.first..end);
            if here.len() == range.len() {
                return Ok(here);
            }
            gathered.extend_from_slice(&here);
        }
        Ok(gathered.into())
    }

    /// Reads all parts and discards them, to check them.
    ///
    /// # Errors
    /// [`StoreError::Damaged`] where a part is missing.
    pub async fn check(mut self) -> Result<(), StoreError> {
        let (mut at, end) = (0, self.layout.end());
        while at < end {
            let to = end.min(at + self.part.bytes.len());
            self.bytes(at..to).await?;
            at = to;
        }
        Ok(())
    }
}

impl FieldsPart {
    fn has(&self, at: usize) -> bool {
        at.checked_sub(self.first).is_some_and(|skipped| skipped < self.bytes.len())
    }
}

#[expect(clippy::needless_pass_by_value, reason = "for map_err")]
fn damaged(error: FieldArraysError) -> StoreError {
    StoreError::damaged(error.to_string())
}

fn cut_off() -> StoreError {
    StoreError::damaged("fields of a step are cut off")
}
