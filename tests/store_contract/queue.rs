//! The order of the queue.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use brinell::jobs::{
    About, ApiKey, ClaimRequest, Clock, JobFilter, JobId, JobNotifier, JobState, KeyId, NewJob,
    Scope, StoreError, Turn, label_of, words,
};
use brinell::store::{StoreLimits, open_postgres, open_sqlite_in_memory};
use brinell_solver::job::Units;
use bytes::Bytes;
use jiff::SignedDuration;

use crate::cluster::Cluster;
use crate::subject::{
    ALL, MEMORY, MEMORY_STORE, QUEUE_CAPACITY, Subject, clock, ids as ids_of, job,
};

pub async fn jobs_are_handed_out_in_order_and_only_once(subject: &Subject) {
    let mut ids = Vec::new();
    for name in ["a", "b", "c", "d"] {
        ids.push(subject.enqueue(name).await);
    }
    assert_eq!(subject.get(ids[2]).await.queue_position, Some(2));
    assert_eq!(ids_of(&subject.claim(3).await), ids[..3]);
    assert_eq!(ids_of(&subject.claim(3).await), ids[3..]);
    assert!(subject.claim(3).await.is_empty());
}

pub async fn a_full_queue_refuses_and_keeps_nothing(subject: &Subject) {
    for _ in 0..QUEUE_CAPACITY {
        subject.enqueue("x").await;
    }
    let one_more = job("more");
    let id = one_more.id;
    let refused = subject.submit(one_more.clone()).await;
    assert!(matches!(refused, Err(StoreError::QueueFull { queued: QUEUE_CAPACITY })));
    assert!(matches!(subject.store.get(id).await, Err(StoreError::NotFound)));
    subject.claim_one().await;
    subject.submit(one_more.clone()).await.unwrap();
}

pub async fn simultaneous_submissions_do_not_overfill_the_queue(subject: &Subject) {
    let mut keys = vec![None];
    for name in ["one", "other"] {
        let (key, _) = ApiKey::generate(name.to_owned(), Scope::Write, subject.clock.now());
        keys.push(Some(key.id));
        subject.store.add_key(key).await.unwrap();
    }
    let batches = (0..9).map(|k| {
        let jobs =
            ["a", "b", "c"].map(|tag| NewJob { submitter: keys[k % 3], ..job(tag) }).to_vec();
        let store = Arc::clone(&subject.store);
        tokio::spawn(async move { store.enqueue_all(jobs, Turn::free()).await.unwrap() })
    });
    let mut taken = 0;
    for batch in batches.collect::<Vec<_>>() {
        taken += batch.await.unwrap().iter().filter(|taken| taken.is_ok()).count();
    }
    assert_eq!((taken, subject.page(ALL).await.0.len()), (QUEUE_CAPACITY, QUEUE_CAPACITY));
}

pub async fn pages_are_newest_first_and_filtered(subject: &Subject) {
    let mut ids = Vec::new();
    for name in ["a", "b", "a"] {
        ids.push(subject.enqueue(name).await);
    }
    ids.reverse();
    assert_eq!(subject.page(ALL).await, (ids.clone(), None));
    let (first, next) = subject.page(JobFilter { limit: 2, ..ALL }).await;
    assert_eq!((first.as_slice(), next), (&ids[..2], Some(ids[1])));
    assert_eq!(
        subject.page(JobFilter { limit: 2, cursor: next, ..ALL }).await,
        (vec![ids[2]], None)
    );
    let tagged = JobFilter { tags: vec![("name".to_owned(), "a".to_owned())], ..ALL };
    assert_eq!(subject.page(tagged).await.0, [ids[0], ids[2]]);
    subject.claim_one().await;
    let running = JobFilter { states: vec![JobState::Running], ..ALL };
    assert_eq!(subject.page(running).await.0, [ids[2]]);

    let both = JobFilter {
        states: vec![JobState::Running, JobState::Queued],
        oldest_first: true,
        limit: 2,
        ..ALL
    };
    assert_eq!(subject.page(both.clone()).await, (vec![ids[2], ids[1]], Some(ids[1])));
    assert_eq!(
        subject.page(JobFilter { cursor: Some(ids[1]), ..both }).await,
        (vec![ids[0]], None)
    );
    let no_job = vec![("name".to_owned(), "a".to_owned()), ("name".to_owned(), "b".to_owned())];
    assert!(subject.page(JobFilter { tags: no_job, ..ALL }).await.0.is_empty());
    let some = JobFilter { ids: vec![ids[2], ids[0], JobId::generate()], ..ALL };
    assert_eq!(subject.page(some).await.0, [ids[0], ids[2]]);
    subject.clock.advance(SignedDuration::from_secs(1));
    let late = subject.enqueue("late").await;
    let second = Clock::now(subject.clock.as_ref());
    assert_eq!(subject.page(JobFilter { since: Some(second), ..ALL }).await.0, [late]);
    assert_eq!(subject.page(JobFilter { until: Some(second), ..ALL }).await.0, ids);
}

pub async fn words_find_their_jobs(subject: &Subject) {
    let about = Some(About {
        title: "Press 7".to_owned(),
        description: "roller R 5 on block, 9000 N, elastic".to_owned(),
        units: Units::Si,
    });
    let of = |words: &[&str]| NewJob {
        about: about.clone(),
        words: words.iter().map(|word| (*word).to_owned()).collect(),
        ..job("x")
    };
    let roller = subject.submit(of(&["hardened", "roller"])).await.unwrap().job;
    let ball = subject.submit(of(&["hardened", "ball"])).await.unwrap().job.id;
    for record in [subject.get(roller.id).await, roller.clone()] {
        assert_eq!(record.tags, job("x").tags, "words and titles are no labels");
        assert_eq!(record.about, about);
    }
    let search =
        |text: &str| JobFilter { tags: words(text).map(|it| label_of(&it)).collect(), ..ALL };
    assert_eq!(subject.page(search("Hardened")).await.0, [ball, roller.id]);
    assert_eq!(subject.page(search("roller, HARDENED")).await.0, [roller.id]);
    assert!(subject.page(search("ball roller")).await.0.is_empty());
    assert!(subject.page(search("roll")).await.0.is_empty());
}

/// More jobs than a page looks at: none is left out, and none is told twice.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
#[ignore = "full"]
async fn pages_of_a_long_list_end_with_a_cursor() {
    let limits = StoreLimits { queue_capacity: 100_000, ..StoreLimits::default() };
    let url = Cluster::shared().database().await;
    let stores = [
        open_sqlite_in_memory(MEMORY_STORE, limits, JobNotifier::new(), clock()).await.unwrap(),
        open_postgres(&url, 4, limits, JobNotifier::new(), None).await.unwrap(),
    ];
    for store in stores {
        let mut rare = Vec::new();
        for batch in 0..12 {
            let tagged = |number| {
                let kind = if number % 2 == 0 { "even" } else { "odd" };
                let tags = [("kind", kind), ("size", if number == 7 { "odd" } else { "small" })];
                let tags = tags.map(|(name, value)| (name.to_owned(), value.to_owned()));
                NewJob { tags: BTreeMap::from(tags), ..NewJob::new(Bytes::from_static(b"{}")) }
            };
            let jobs: Vec<_> = (0..1000).map(tagged).collect();
            if batch % 5 == 0 {
                rare.push(jobs[7].id);
            }
            let jobs = jobs.into_iter().enumerate();
            let jobs = jobs.filter(|(number, _)| *number != 7 || batch % 5 == 0);
            store.enqueue_all(jobs.map(|(_, job)| job).collect(), Turn::free()).await.unwrap();
        }
        for (value, expected) in [("odd", Some(&rare)), ("small", None)] {
            let label = |name: &str, value: &str| (name.to_owned(), value.to_owned());
            let tags = vec![label("kind", "odd"), label("size", value)];
            let mut filter = JobFilter { tags, oldest_first: true, ..ALL };
            let (mut found, mut pages) = (Vec::new(), 0);
            loop {
                let page = store.list(&filter).await.unwrap();
                found.extend(page.jobs.into_iter().map(|job| job.id));
                pages += 1;
                let Some(next) = page.next else { break };
                filter.cursor = Some(next);
            }
            assert!(pages < 100, "{pages} pages");
            match expected {
                Some(rare) => assert_eq!(&found, rare),
                None => assert_eq!(found.len(), 12 * 499),
            }
        }
    }
}

pub async fn the_highest_priority_goes_first(subject: &Subject) {
    let mut ids = Vec::new();
    for (name, priority) in [("a", 0), ("b", -3), ("c", 7), ("d", 0)] {
        ids.push(subject.submit(NewJob { priority, ..job(name) }).await.unwrap().job.id);
    }
    let mut places = Vec::new();
    for id in &ids {
        places.push(subject.get(*id).await.queue_position);
    }
    assert_eq!(places, [Some(1), Some(3), Some(0), Some(2)]);
    assert_eq!(ids_of(&subject.claim(4).await), [ids[2], ids[0], ids[3], ids[1]]);
    assert_eq!(subject.get(ids[2]).await.priority, 7);
}

pub async fn jobs_are_handed_out_within_the_memory(subject: &Subject) {
    let mut ids = Vec::new();
    for (name, memory) in [("huge", MEMORY + 1), ("half", 500), ("most", 600), ("tiny", 1)] {
        ids.push(subject.submit(NewJob { memory, ..job(name) }).await.unwrap().job.id);
    }
    let claims = subject.claim(4).await;
    assert_eq!(
        ids_of(&claims),
        [ids[1]],
        "the next does not fit beside it, and the small one must not overtake"
    );
    assert_eq!(claims[0].memory, 500);
    let rest = ClaimRequest { free_memory: 500, ..Subject::request(3) };
    assert!(subject.claims(rest).await.jobs.is_empty());
    assert_eq!(ids_of(&subject.claim(4).await), [ids[2], ids[3]]);
    assert!(subject.claim(4).await.is_empty(), "what never fits is left to others");
    let larger =
        ClaimRequest { free_memory: 2 * MEMORY, memory: 2 * MEMORY, ..Subject::request(1) };
    assert_eq!(ids_of(&subject.claims(larger).await.jobs), [ids[0]]);
}

pub async fn many_workers_at_once_never_get_the_same_job(subject: &Subject) {
    let mut queued = BTreeSet::new();
    for _ in 0..QUEUE_CAPACITY {
        queued.insert(subject.enqueue("x").await);
    }
    let claims = (0..8).map(|_| {
        let (store, request) = (subject.store.clone(), Subject::request(1));
        tokio::spawn(async move { store.claim(&request).await.unwrap() })
    });
    let mut claimed: Vec<JobId> = Vec::new();
    for claim in claims.collect::<Vec<_>>() {
        claimed.extend(ids_of(&claim.await.unwrap().jobs));
    }
    // A worker may look away while another holds the row; what is left is handed out next.
    claimed.extend(ids_of(&subject.claim(QUEUE_CAPACITY).await));
    assert_eq!(claimed.len(), QUEUE_CAPACITY);
    assert_eq!(claimed.into_iter().collect::<BTreeSet<_>>(), queued);
}

pub async fn jobs_are_listed_by_submitter(subject: &Subject) {
    let (one, other) = (KeyId::generate(), KeyId::generate());
    let mine = subject.submit(NewJob { submitter: Some(one), ..job("a") }).await.unwrap().job;
    subject.submit(NewJob { submitter: Some(other), ..job("a") }).await.unwrap();
    subject.enqueue("a").await;
    assert_eq!(subject.get(mine.id).await.submitter, Some(one));
    assert_eq!(
        subject.page(JobFilter { submitter: Some(one), ..ALL }).await,
        (vec![mine.id], None)
    );
}
