#!/usr/bin/env bash
# The verdict on one part within a minute of a change: its unit tests and a dozen named problems.
#
# usage: scripts/quick.sh PART; PART is a crate without `brinell-` (solver, contact, ...), sparse-cholesky,
# service or page. Slow tests stay with .ci/run and .ci/full.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
part=${1:?"which part? a crate, service or page"}

# One problem for each coupling, analysis, law family, theory and kind of load.
solver_problems=(
    paper_problem::iterations_of_every_coupling_are_bounded
    line_contact::equal_cylinders_have_hertz_pressure
    point_contact::equal_spheres_have_hertz_pressure_and_approach
    plane_stress::equal_discs_have_hertz_pressure
    contact_solvers::half_planes_give_the_pressure_of_hertz
    contact_solvers::pivots_are_the_pairs_in_contact_plus_one
    thick_cylinder::patch_test
    bodies_of_revolution::patch_test
    flow_theory::one_increment_is_deformation_theory
    flow_theory::an_elastic_loop_closes
    invariants::half_and_full_models_agree
    soundness::wrong_contact_sets_are_found_out
    targets::an_elastic_contact_meets_hertz
    model::refused::several_faults_at_once_in_document_order
    purity::the_solver_and_its_factorization_are_pure
)
# One question for each route family, the queue, the lock of the document and the command line.
service_problems=(
    jobs::solve_answers_with_the_result
    jobs::a_job_is_queued_followed_and_fetched
    events::a_running_job_is_followed_to_its_end
    batch::each_job_is_answered_as_by_itself
    exports::a_step_of_a_sweep_is_chosen
    keys::without_a_good_key_nothing_under_v1_is_answered
    troubled::a_client_that_hangs_up_cancels_its_solve
    troubled::no_nan_leaves
    shutdown::sigterm_ends_an_idle_service_with_success
    readme::every_curl_example_works
    generated::the_document_is_in_the_repository
)

case $part in
solver)
    cargo test -p brinell-solver --lib
    cargo test -p brinell-solver --test solver -- --exact "${solver_problems[@]}"
    ;;
service)
    cargo test -p brinell --lib
    cargo test -p brinell --test http --test openapi -- --exact "${service_problems[@]}"
    ;;
page)
    npm --prefix tests/page run check
    [ -x target/debug/brinell ] || cargo build
    npm --prefix tests/page run smoke
    ;;
*)
    [ -d "crates/$part" ] || part=brinell-$part
    cargo test -p "$part"
    ;;
esac
