//! Announcements of changes between processes, by `LISTEN` and `NOTIFY`.
//!
//! Each process listens on a connection of its own and notifies on its others, after its changes
//! are committed. `NOTIFY` inside the changing transaction would take a lock of the whole database
//! until the commit is on the disk, and the commits of all processes would wait for each other. A
//! notification may be lost with its connection or process; every process therefore also queries
//! once a second.

use std::sync::Arc;
use std::time::Duration;

use sqlx::postgres::PgListener;
use sqlx::{Executor, PgPool};
use tokio::sync::mpsc::{Receiver, Sender, channel};
use tokio::time::{sleep, timeout};

use crate::jobs::{JobId, JobNotifier, WorkerId};
use crate::store::sql::Change;

/// Channels of the changes that a worker needs to know of, and of those that clients follow. Each
/// process that listens is woken by every change on its channels.
const OF_WORKERS: &str = "brinell_work";
const OF_CLIENTS: &str = "brinell";

/// Most changes in one statement, and most changes that wait for one.
const BATCH: usize = 256;
const WAITING: usize = 4096;

/// Time between two tries to listen.
const RECONNECT_INTERVAL: Duration = Duration::from_secs(1);

/// Time without a notification after which the server is asked for a sign of life, and the longest
/// wait for an answer.
const SILENCE: Duration = Duration::from_secs(10);

/// Announces changes to other processes, in the order of the calls.
#[derive(Debug)]
pub(super) struct Announcer(Sender<Change>);

impl Announcer {
    /// Starts the task that notifies. The task ends when the announcer is dropped and its queue is
    /// empty.
    pub(super) fn start(pool: &PgPool, node: WorkerId) -> Self {
        let (sender, changes) = channel(WAITING);
        tokio::spawn(tell(pool.clone(), node, changes));
        Self(sender)
    }

    /// Announces changes that are committed.
    pub(super) fn announce(&self, changes: &[Change]) {
        for change in changes {
            if self.0.try_send(*change).is_err() {
                tracing::debug!("other processes are not told of a change");
            }
        }
    }
}

async fn tell(pool: PgPool, node: WorkerId, mut changes: Receiver<Change>) {
    let mut batch = Vec::with_capacity(BATCH);
    while changes.recv_many(&mut batch, BATCH).await > 0 {
        let (channels, messages): (Vec<&str>, Vec<String>) =
            batch.drain(..).map(|change| (channel_of(change), message(node, change))).unzip();
        // The notifications of all processes wait for each other's commits, and these for no disk.
        let notify = sqlx::query(
            "SELECT set_config('synchronous_commit', 'off', true) UNION ALL
             SELECT pg_notify(t.channel, t.message)::text
             FROM unnest($1::text[], $2::text[]) AS t (channel, message)",
        );
        let notify = notify.bind(channels).bind(messages);
        let error = match timeout(SILENCE, notify.execute(&pool)).await {
            Ok(Ok(_)) => continue,
            Ok(Err(error)) => error.to_string(),
            Err(late) => late.to_string(),
        };
        tracing::warn!(error, "other processes are not told of changes; they look once a second");
    }
}

fn channel_of(change: Change) -> &'static str {
    match change {
        Change::Work | Change::Cancel(_) => OF_WORKERS,
        Change::Progress(_) | Change::Finished(_) => OF_CLIENTS,
    }
}

/// Payload of a notification: sender, kind of change, job.
fn message(node: WorkerId, change: Change) -> String {
    match change {
        Change::Work => format!("{node} work"),
        Change::Progress(id) => format!("{node} progress {id}"),
        Change::Cancel(id) => format!("{node} cancel {id}"),
        Change::Finished(id) => format!("{node} finished {id}"),
    }
}

/// Parses a notification; `None` if this process sent it or a newer version's kind is unknown.
fn heard(message: &str, node: WorkerId) -> Option<Change> {
    let mut words = message.split(' ');
    if words.next()? == node.to_string() {
        return None;
    }
    let (what, id) = (words.next()?, words.next().and_then(|id| id.parse::<JobId>().ok()));
    match (what, id) {
        ("work", None) => Some(Change::Work),
        ("progress", Some(id)) => Some(Change::Progress(id)),
        ("cancel", Some(id)) => Some(Change::Cancel(id)),
        ("finished", Some(id)) => Some(Change::Finished(id)),
        _ => None,
    }
}

/// Forwards the notifications of other processes for as long as the store is open.
pub(super) async fn listen(pool: PgPool, node: WorkerId, notifier: Arc<JobNotifier>) {
    loop {
        if let Err(error) = listen_once(&pool, node, &notifier).await {
            tracing::warn!(%error, "not listening to the database; looking once a second instead");
        }
        sleep(RECONNECT_INTERVAL).await;
    }
}

async fn listen_once(
    pool: &PgPool,
    node: WorkerId,
    notifier: &JobNotifier,
) -> Result<(), sqlx::Error> {
    let mut listener = PgListener::connect_with(pool).await?;
    listener.listen(OF_WORKERS).await?;
    if !notifier.is_of_worker() {
        listener.listen(OF_CLIENTS).await?;
    }
    loop {
        // Notifications sent before this connection listened are lost: every waiter queries the
        // store again.
        notifier.announce_gap();
        loop {
            let Ok(received) = timeout(SILENCE, listener.try_recv()).await else {
                // The line may be dead, which only an answer can tell.
                let answered = timeout(SILENCE, listener.execute("SELECT 1")).await;
                answered.map_err(|late| sqlx::Error::Io(late.into()))??;
                continue;
            };
            let Some(notification) = received? else { break };
            if let Some(change) = heard(notification.payload(), node) {
                change.announce(notifier);
            }
        }
        tracing::warn!("the connection that listens to the database broke and is made anew");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn others_are_heard_and_one_self_is_not() {
        let (here, there, id) = (WorkerId::generate(), WorkerId::generate(), JobId::generate());
        for change in
            [Change::Work, Change::Progress(id), Change::Cancel(id), Change::Finished(id)]
        {
            assert_eq!(heard(&message(there, change), here), Some(change));
            assert_eq!(heard(&message(here, change), here), None);
        }
        for noise in ["", "x", "x y", "x cancel", "x cancel y"] {
            assert_eq!(heard(noise, here), None, "{noise:?}");
        }
    }
}
