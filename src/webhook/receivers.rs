//! Fair delivery: a receiver that is slow, or has many announcements, does not delay the others.

use std::collections::{HashMap, VecDeque};
use std::time::Duration;

use crate::jobs::{Delivery, KeyId};

/// Longest time of an attempt, and the lease of one.
pub(super) const ATTEMPT: Duration = Duration::from_secs(15);
pub(super) const LEASE: Duration = Duration::from_mins(1);

/// Attempts at the same time.
const AT_ONCE: usize = 64;

/// Part of the attempts, and of the announcements in memory, that one API key may have.
const OF_KEY: usize = 4;

/// Attempts at the same time to one receiver, and to one that is slow.
const TO_ONE: usize = 4;
const TO_ONE_SLOW: usize = 1;

/// Duration of the last attempt above which a receiver counts as slow.
const SLOW: Duration = Duration::from_secs(2);

/// Most announcements in memory.
const HELD: usize = 256;

/// Shortest postponement of an announcement that found no room.
const SHORTEST_PAUSE: Duration = Duration::from_millis(100);

/// Receivers that are remembered without announcements.
const REMEMBERED: usize = 1000;

/// A receiver: a host and an API key. Announcements of two keys to one host do not wait for each
/// other.
pub(super) type Receiver = (String, Option<KeyId>);

/// An announcement that found no room, and the time to postpone it by.
pub(super) type Postponed = (Delivery, Duration);

/// The announcements in memory, by receiver.
#[derive(Debug, Default)]
pub(super) struct Receivers {
    queues: HashMap<Receiver, Queue>,
    running: usize,
}

#[derive(Debug, Default)]
struct Queue {
    waiting: VecDeque<Delivery>,
    running: usize,
    /// Duration of the last attempt.
    took: Duration,
}

impl Queue {
    fn at_once(&self) -> usize {
        if self.took < SLOW { TO_ONE } else { TO_ONE_SLOW }
    }

    /// Returns how many announcements may wait so that the last attempt still ends within its
    /// lease.
    fn room(&self) -> usize {
        let rounds = (LEASE.as_secs() / ATTEMPT.as_secs()).saturating_sub(1);
        self.at_once() * usize::try_from(rounds).unwrap_or(1)
    }

    fn pause(&self) -> Duration {
        (2 * self.took).clamp(SHORTEST_PAUSE, ATTEMPT)
    }

    fn is_idle(&self) -> bool {
        self.waiting.is_empty() && self.running == 0
    }
}

impl Receivers {
    /// Returns the number of announcements that still fit.
    pub(super) fn room(&self) -> usize {
        HELD.saturating_sub(
            self.running + self.queues.values().map(|queue| queue.waiting.len()).sum::<usize>(),
        )
    }

    /// Queues an announcement, or returns it if the queue of its receiver is full.
    pub(super) fn offer(&mut self, receiver: Receiver, delivery: Delivery) -> Option<Postponed> {
        if self.queues.len() >= REMEMBERED {
            self.queues.retain(|_, queue| !queue.is_idle());
        }
        let of_key = self.of_key(receiver.1, |queue| queue.running + queue.waiting.len());
        let queue = self.queues.entry(receiver).or_default();
        if of_key >= HELD / OF_KEY || queue.waiting.len() >= queue.room() {
            return Some((delivery, queue.pause()));
        }
        queue.waiting.push_back(delivery);
        None
    }

    /// Returns the next attempt: of the receiver with the fewest running attempts.
    pub(super) fn next(&mut self) -> Option<(Receiver, Delivery)> {
        if self.running >= AT_ONCE {
            return None;
        }
        let may = |queue: &Queue| !queue.waiting.is_empty() && queue.running < queue.at_once();
        let ready = self.queues.iter().filter(|(_, queue)| may(queue));
        let ready = ready.map(|(to, queue)| (self.of_key(to.1, |queue| queue.running), queue, to));
        let ready = ready.filter(|(of_key, ..)| *of_key < AT_ONCE / OF_KEY);
        let (_, _, receiver) = ready.min_by_key(|(of_key, queue, _)| (*of_key, queue.running))?;
        let receiver = receiver.clone();
        let queue = self.queues.get_mut(&receiver)?;
        let delivery = queue.waiting.pop_front()?;
        queue.running += 1;
        self.running += 1;
        Some((receiver, delivery))
    }

    /// Sums a number over all receivers of a key.
    fn of_key(&self, key: Option<KeyId>, number: impl Fn(&Queue) -> usize) -> usize {
        self.queues.iter().filter(|((_, of), _)| *of == key).map(|(_, queue)| number(queue)).sum()
    }

    /// Records the end and duration of an attempt. If the receiver proves slow, returns the
    /// announcements that can no longer be attempted within their leases.
    pub(super) fn ended(&mut self, receiver: &Receiver, took: Duration) -> Vec<Postponed> {
        let Some(queue) = self.queues.get_mut(receiver) else { return Vec::new() };
        queue.running = queue.running.saturating_sub(1);
        self.running = self.running.saturating_sub(1);
        queue.took = took;
        let (room, pause) = (queue.room().min(queue.waiting.len()), queue.pause());
        queue.waiting.split_off(room).into_iter().map(|delivery| (delivery, pause)).collect()
    }
}

#[cfg(test)]
mod tests {
    use uuid::Uuid;

    use super::*;
    use crate::jobs::JobId;

    fn delivery() -> Delivery {
        let (job, id) = (JobId::generate(), Uuid::new_v4());
        Delivery { job, id, url: String::new(), attempt: 1, submitter: None, trace: None }
    }

    fn receiver(name: &str) -> Receiver {
        (name.to_owned(), None)
    }

    /// Begins all attempts that may begin and returns their number.
    fn begin(receivers: &mut Receivers) -> usize {
        std::iter::from_fn(|| receivers.next()).count()
    }

    #[test]
    fn a_receiver_that_much_is_due_to_leaves_room_for_others() {
        let mut receivers = Receivers::default();
        let taken =
            (0..100).filter(|_| receivers.offer(receiver("much"), delivery()).is_none()).count();
        assert_eq!((taken, begin(&mut receivers)), (12, 4));
        let other_key = ("much".to_owned(), Some(KeyId::generate()));
        assert!(
            [receiver("other"), other_key]
                .into_iter()
                .all(|to| receivers.offer(to, delivery()).is_none())
        );
        assert_eq!(begin(&mut receivers), 2, "another host, and the host for another key");
        assert_eq!(receivers.room(), HELD - 14);
        assert_eq!(receivers.offer(receiver("much"), delivery()), None);
        let (_, pause) =
            (0..9).find_map(|_| receivers.offer(receiver("much"), delivery())).unwrap();
        assert_eq!(pause, SHORTEST_PAUSE, "it has not been slow so far");
    }

    #[test]
    fn a_slow_receiver_has_one_attempt_at_a_time_until_it_is_quick_again() {
        let (mut receivers, slow) = (Receivers::default(), receiver("slow"));
        while receivers.offer(slow.clone(), delivery()).is_none() {}
        assert_eq!(begin(&mut receivers), 4);
        let postponed = receivers.ended(&slow, ATTEMPT);
        assert_eq!(
            postponed.len(),
            5,
            "of eight that wait three have their turn within the lease"
        );
        assert!(postponed.iter().all(|(_, pause)| *pause == ATTEMPT));
        assert_eq!(begin(&mut receivers), 0);
        for _ in 0..3 {
            assert!(receivers.ended(&slow, ATTEMPT).is_empty());
        }
        assert_eq!(begin(&mut receivers), 1);
        receivers.ended(&slow, Duration::from_millis(3));
        assert_eq!(begin(&mut receivers), 2);
    }

    #[test]
    fn no_more_are_made_at_once_than_may_be_and_the_idle_are_forgotten() {
        let mut receivers = Receivers::default();
        let keys: Vec<KeyId> = (0..2 * OF_KEY).map(|_| KeyId::generate()).collect();
        let to = |host: usize| (host.to_string(), Some(keys[host % keys.len()]));
        for host in 0..2 * AT_ONCE {
            assert_eq!(receivers.offer(to(host), delivery()), None);
        }
        assert_eq!(begin(&mut receivers), AT_ONCE);
        for host in 0..2 * AT_ONCE {
            receivers.ended(&to(host), Duration::ZERO);
            begin(&mut receivers);
        }
        for host in 0..2 * REMEMBERED {
            assert_eq!(receivers.offer(receiver(&format!("h{host}")), delivery()), None);
            while let Some((receiver, _)) = receivers.next() {
                receivers.ended(&receiver, Duration::ZERO);
            }
        }
        assert!(receivers.queues.len() <= REMEMBERED, "{}", receivers.queues.len());
    }
    #[test]
    fn a_key_has_a_quarter_of_the_attempts_whatever_hosts_it_names() {
        let mut receivers = Receivers::default();
        let (greedy, modest) = (Some(KeyId::generate()), Some(KeyId::generate()));
        let taken = (0..1000)
            .filter(|host| receivers.offer((host.to_string(), greedy), delivery()).is_none());
        assert_eq!(taken.count(), HELD / OF_KEY);
        assert_eq!(begin(&mut receivers), AT_ONCE / OF_KEY);
        assert_eq!(receivers.offer(("0".to_owned(), modest), delivery()), None);
        assert_eq!(begin(&mut receivers), 1);
    }
}
