//! The contract of `JobStore`. Each backend runs the whole suite.
#![expect(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a test that cannot go on says where"
)]

#[path = "../support/cluster.rs"]
mod cluster;
mod damage;
mod deaf;
mod deliveries;
mod dropped;
mod durable;
mod fair_share;
mod in_memory;
mod keys;
mod leases;
mod life;
mod names;
mod pauses;
mod queue;
mod quotas;
mod rate;
mod results;
mod silence;
mod subject;
mod upgrade;

/// `contract!(name, start)`: all promises, each on a store of its own; an attribute of its tests may
/// stand before.
macro_rules! contract {
    ($backend:ident, $start:expr) => {
        contract! { [cfg(all())] $backend, $start }
    };
    ($attribute:tt $backend:ident, $start:expr) => {
        contract! {
            $attribute $backend, $start,
            life a_job_goes_its_way;
            life unknown_jobs_are_not_found;
            life a_queued_job_is_cancelled_at_once;
            life a_running_job_is_asked_to_stop;
            life failures_are_kept;
            life only_finished_jobs_are_deleted;
            life changes_are_announced_after_they_can_be_read;
            life old_jobs_are_swept_each_in_its_time;
            queue jobs_are_handed_out_in_order_and_only_once;
            queue a_full_queue_refuses_and_keeps_nothing;
            queue simultaneous_submissions_do_not_overfill_the_queue;
            queue pages_are_newest_first_and_filtered;
            queue words_find_their_jobs;
            queue the_highest_priority_goes_first;
            queue jobs_are_handed_out_within_the_memory;
            queue many_workers_at_once_never_get_the_same_job;
            queue jobs_are_listed_by_submitter;
            leases only_the_holder_of_the_lease_writes;
            leases an_expired_job_is_handed_out_again_and_given_up_at_last;
            leases heartbeats_keep_a_job_and_tell_of_cancellation;
            leases an_expired_job_that_was_to_stop_is_cancelled;
            leases a_worker_gives_back_what_it_does_not_know;
            leases last_attempts_run_one_at_a_time;
            leases a_released_job_is_queued_as_if_never_taken_up;
            results steps_are_kept_as_they_are_finished;
            results fields_are_read_part_by_part;
            results a_later_attempt_begins_without_steps;
            results steps_that_begin_anew_take_the_place_of_others;
            results the_oldest_results_make_room;
            results a_key_makes_room_for_itself_alone;
            results a_job_without_a_report_keeps_no_steps;
            fair_share a_greedy_key_does_not_hold_up_another;
            fair_share a_key_leaves_a_place_of_a_worker_to_others;
            fair_share keys_share_by_solver_time_and_not_by_number;
            fair_share solver_time_is_forgotten_within_a_minute;
            fair_share a_small_job_does_not_wait_for_memory;
            fair_share a_key_has_its_places_in_the_queue_and_no_more;
            quotas a_key_has_as_many_jobs_running_as_it_may;
            quotas a_key_stores_as_much_as_it_may;
            quotas a_key_asks_for_the_priority_that_it_may;
            quotas submissions_at_the_same_instant_are_counted;
            keys api_keys_are_kept_and_revoked;
            keys a_secret_is_replaced_and_limits_are_changed;
            names the_same_name_is_the_same_job;
            names a_name_is_free_again_with_its_job;
            names a_refused_job_does_not_take_its_name;
            names the_same_name_at_the_same_instant_is_one_job;
            deliveries an_announcement_is_due_with_the_end_of_its_job;
            deliveries the_end_of_a_lost_job_is_announced;
            deliveries an_attempt_is_made_again_until_its_end_is_told;
            deliveries abandoned_announcements_are_not_due_again;
            deliveries many_at_once_never_get_the_same_announcement;
            deliveries the_trace_of_a_submission_goes_with_its_job;
            names jobs_together_are_taken_in_or_refused_one_by_one;
            names batches_with_and_without_names_do_not_lock_each_other_out;
            deaf a_file_breaks_off_where_its_result_does;
            deaf streams_that_nobody_reads_hold_no_reader;
            dropped a_client_that_goes_leaves_no_job_behind;
            dropped a_client_that_means_to_come_again_finds_its_job;
            dropped changes_are_announced_although_their_client_has_gone;
            dropped waiting_submissions_end_when_the_service_closes;
            dropped names_in_any_order_are_taken_in_together;
            quotas a_key_that_has_ended_hands_nothing_in;
        }
    };
    ($attribute:tt $backend:ident, $start:expr, $($part:ident $promise:ident;)*) => {
        mod $backend {
            $(#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
            #$attribute
            async fn $promise() {
                crate::$part::$promise(&$start).await;
            })*
        }
    };
}

contract!(memory, crate::subject::Subject::memory(crate::subject::MEMORY_STORE).await);
contract!(sqlite, crate::subject::Subject::sqlite().await);
contract!(
    [cfg_attr(no_postgresql, ignore = "needs PostgreSQL: install it, or python3 with pip")]
    postgres,
    crate::subject::Subject::postgres().await
);
