//! Several jobs with their results, sent as they are read: memory holds one result at a time.

use axum::body::{Body, Bytes};
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};
use tokio::sync::mpsc::{self, Receiver, Sender};

use super::BatchItem;
use crate::http::HttpState;
use crate::http::access::Caller;
use crate::http::job_path::check_seen;
use crate::http::prefix::Prefix;
use crate::http::problem::Problem;
use crate::http::query::Selection;
use crate::http::result_body::SentResult;
use crate::http::wire::JobDocument;
use crate::http::written_body::written;
use crate::jobs::{JobId, StoreError};

/// Bytes of a job that are held back until the job is complete: if the job is removed meanwhile,
/// the answer can still say so.
const HELD: usize = 1 << 20;

/// Answers 200 with the jobs of these ids.
pub(in crate::http) fn fetched(
    state: HttpState,
    caller: Caller,
    prefix: Prefix,
    selection: Selection,
    ids: Vec<JobId>,
) -> Response {
    let turn = state.turn(caller.key());
    let write = move |sender| async move {
        let fetch = Fetch { state, caller, prefix, selection, sender };
        fetch.run(ids).await
    };
    ([(CONTENT_TYPE, "application/json")], Body::from_stream(written(turn, write))).into_response()
}

struct Fetch {
    state: HttpState,
    caller: Caller,
    prefix: Prefix,
    selection: Selection,
    sender: Sender<Bytes>,
}

impl Fetch {
    async fn run(&self, ids: Vec<JobId>) -> Result<(), StoreError> {
        let mut refused = 0;
        let count = ids.len();
        let mut before = "{\"jobs\":[".to_owned();
        for id in ids {
            if self
                .sender
                .send(std::mem::replace(&mut before, ",".to_owned()).into())
                .await
                .is_err()
            {
                // The client has gone.
                return Ok(());
            }
            if let Err(problem) = self.send(id).await? {
                refused += 1;
                let item = BatchItem::refused(Some(id), problem);
                let item = serde_json::to_vec(&item).map_err(StoreError::unavailable)?;
                let _ = self.sender.send(item.into()).await;
            }
        }
        let end = format!("],\"accepted\":{},\"refused\":{refused}}}", count - refused);
        let _ = self.sender.send(end.into()).await;
        Ok(())
    }

    /// Sends one job; returns a problem if it fails before the first byte of the job.
    async fn send(&self, id: JobId) -> Result<Result<(), Problem>, StoreError> {
        let found = async {
            check_seen(&self.state, self.caller, id).await?;
            let job =
                JobDocument::of(&self.state, self.state.jobs.get(id).await?, &self.prefix).await?;
            let head = if job.done { self.state.jobs.result(id).await? } else { None };
            Ok::<_, StoreError>((job, head))
        };
        let (job, head) = match found.await {
            Ok(found) => found,
            Err(error) => return Ok(Err(error.into())),
        };
        let item = |job: JobDocument| {
            serde_json::to_vec(&BatchItem::found(job)).map_err(StoreError::unavailable)
        };
        let Some(head) = head else {
            let _ = self.sender.send(item(job)?.into()).await;
            return Ok(Ok(()));
        };
        // The job is the last member of the item.
        let mut before = item(job)?;
        before.truncate(before.len().saturating_sub(2));
        before.extend_from_slice(b",\"result\":");
        let around = [before.into(), Bytes::from_static(b"}}")];
        let (state, selection) = (self.state.clone(), self.selection.clone());
        let result = SentResult { state, caller: self.caller, id, head, selection };
        let (inner, pieces) = mpsc::channel(1);
        let write = async {
            let written = result.send(around, &inner).await;
            drop(inner);
            written
        };
        let (written, held) = tokio::join!(write, self.pass_on(pieces));
        match (written, held) {
            // The job was removed meanwhile, by its owner or to free space.
            (Err(error @ StoreError::NotFound), Some(_)) => Ok(Err(error.into())),
            (Ok(Ok(())), Some(held)) => {
                for piece in held {
                    let _ = self.sender.send(piece).await;
                }
                Ok(Ok(()))
            }
            (written, _) => written,
        }
    }

    /// Sends the pieces of a job once they exceed the bytes to hold back; returns the pieces if
    /// nothing was sent.
    async fn pass_on(&self, mut pieces: Receiver<Bytes>) -> Option<Vec<Bytes>> {
        let mut held = Some(Vec::new());
        let mut bytes = 0;
        while let Some(piece) = pieces.recv().await {
            bytes += piece.len();
            let ready = match &mut held {
                Some(waiting) => {
                    waiting.push(piece);
                    if bytes > HELD { held.take().unwrap_or_default() } else { Vec::new() }
                }
                None => vec![piece],
            };
            for piece in ready {
                let _ = self.sender.send(piece).await;
            }
            if self.sender.is_closed() {
                // If the channel is closed, the client has gone.
                break;
            }
        }
        held
    }
}
