"""The service through openapi-python-client: typed in, typed out, errors as models."""

import os
import sys
from http import HTTPStatus

from brinell_client import AuthenticatedClient
from brinell_client.api.jobs import batch_submit, cancel_job, get_events, get_job, list_jobs, post_job, post_solve
from brinell_client.api.results import batch_fetch, get_field_vtu, get_result, get_summary_csv
from brinell_client.api.theory import post_validate
from brinell_client.models import (
    Analysis,
    BatchAnswer,
    BatchedJob,
    BatchOfIds,
    BatchOfJobs,
    Bilinear,
    ContactBody,
    ContactJob,
    Cylinder,
    Deformable,
    ForceLoad,
    Job,
    JobList,
    OutputSettings,
    Problem,
    Report,
    Validation,
)
from uses import assert_csv, assert_events, assert_peak, assert_vtu


def reference_problem() -> ContactJob:
    """Two steel cylinders of 20 mm radius at three times their yield stress."""

    def cylinder() -> ContactBody:
        law = Bilinear(law="bilinear", yield_stress=500.0, tangent_modulus=10500.0)
        steel = Deformable(young_modulus=210000.0, poisson_ratio=0.3, plasticity=law)
        return ContactBody(shape=Cylinder(type_="cylinder", radius=20.0), material=steel)

    load = ForceLoad(force=612.6106)
    return ContactJob(analysis=Analysis.PLANE_STRAIN, upper=cylinder(), lower=cylinder(), load=load)


def main() -> None:
    # A service that asks for no keys takes no notice of this one.
    client = AuthenticatedClient(base_url=sys.argv[1], token=os.environ["BRINELL_API_KEY"])
    job = reference_problem()

    validation = post_validate.sync(client=client, body=job)
    assert isinstance(validation, Validation) and validation.estimate.equations > 1000, validation

    solved = post_solve.sync(client=client, body=job)
    assert isinstance(solved, Job) and isinstance(solved.result, Report), solved
    assert solved.result.status == "converged"
    assert_peak(solved.result.steps[0].answers)

    job.output = OutputSettings(fields=True)
    submitted = post_job.sync(client=client, body=job, idempotency_key="python", priority=5)
    assert isinstance(submitted, Job), submitted
    done = get_job.sync(submitted.id, client=client, wait=60.0)
    assert isinstance(done, Job) and done.done and done.has_result, done
    result = get_result.sync(submitted.id, client=client, fields="contact")
    assert isinstance(result, Report), result
    assert_peak(result.steps[0].answers)

    jobs = list_jobs.sync(client=client, limit=10)
    assert isinstance(jobs, JobList) and any(one.id == submitted.id for one in jobs.jobs), jobs

    cancelled = cancel_job.sync(submitted.id, client=client)
    assert isinstance(cancelled, Job) and cancelled.done, cancelled

    batch = batch_submit.sync(client=client, body=BatchOfJobs(jobs=[BatchedJob(job=job, priority=5)]))
    assert isinstance(batch, BatchAnswer) and batch.accepted == 1 and isinstance(batch.jobs[0].job, Job), batch
    fetched = batch_fetch.sync(client=client, body=BatchOfIds(ids=[submitted.id]), fields="contact")
    assert isinstance(fetched, BatchAnswer) and isinstance(fetched.jobs[0].job, Job), fetched
    assert isinstance(fetched.jobs[0].job.result, Report), fetched

    job.load = ForceLoad(force=-1.0)
    problem = post_solve.sync(client=client, body=job)
    assert isinstance(problem, Problem) and isinstance(problem.errors, list), problem
    assert problem.errors[0].pointer == "#/load/force" and problem.errors[0].code == "out_of_range", problem

    events = get_events.sync_detailed(submitted.id, client=client)
    assert events.status_code == HTTPStatus.OK
    assert_events(events.content.decode())
    csv = get_summary_csv.sync_detailed(submitted.id, client=client)
    assert csv.status_code == HTTPStatus.OK
    assert_csv(csv.content.decode())
    vtu = get_field_vtu.sync_detailed(submitted.id, client=client)
    assert vtu.status_code == HTTPStatus.OK
    assert_vtu(vtu.content.decode())
    print("openapi-python-client: eleven uses")


if __name__ == "__main__":
    main()
