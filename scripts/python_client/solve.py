"""Solves a job through the generated client: typed in, typed out, errors as models."""

import json
import sys
from http import HTTPStatus

from brinell_client import Client
from brinell_client.api.jobs import get_job, post_job, post_solve
from brinell_client.api.results import get_pressure_csv, get_result
from brinell_client.api.service import get_capacity, get_examples
from brinell_client.api.theory import post_hertz, post_validate
from brinell_client.models import (
    Analysis,
    Bilinear,
    ContactBody,
    Cylinder,
    Deformable,
    ForceLoad,
    ContactJob,
    JobState,
    Problem,
    SolveStatus,
)


def reference_problem() -> ContactJob:
    """Two steel cylinders of 20 mm radius at three times their yield stress."""

    def cylinder() -> ContactBody:
        law = Bilinear(law="bilinear", yield_stress=500.0, tangent_modulus=10500.0)
        steel = Deformable(young_modulus=210000.0, poisson_ratio=0.3, plasticity=law)
        return ContactBody(shape=Cylinder(type_="cylinder", radius=20.0), material=steel)

    load = ForceLoad(force=612.6106)
    return ContactJob(analysis=Analysis.PLANE_STRAIN, upper=cylinder(), lower=cylinder(), load=load)


def main() -> None:
    client = Client(base_url=sys.argv[1], timeout=60.0)
    job = reference_problem()

    report = post_solve.sync(client=client, body=job)
    assert report.status is SolveStatus.CONVERGED, report
    step = report.steps[0]
    assert abs(step.contact.peak_pressure - 1182.6) < 1.0, step.contact.peak_pressure
    assert abs(step.hertz.peak_pressure - 1500.0) < 1.0, step.hertz.peak_pressure
    assert step.subsurface.upper.depth[0] == 0.0 and step.plasticity.lower.yielded

    receipt = post_job.sync(client=client, body=job, idempotency_key="python", priority=5)
    document = get_job.sync(receipt.id, client=client, wait=60.0)
    assert document.status is JobState.SUCCEEDED and document.progress.latest.iteration > 1, document
    result = get_result.sync(receipt.id, client=client)
    assert result.steps[0].contact.peak_pressure == step.contact.peak_pressure
    assert get_pressure_csv.sync_detailed(receipt.id, client=client).status_code == HTTPStatus.OK

    assert post_validate.sync(client=client, body=job).estimate.equations > 1000
    assert post_hertz.sync(client=client, body=job).steps[0].yields
    assert get_capacity.sync(client=client).solvers >= 1
    for example in get_examples.sync(client=client).examples:
        assert post_validate.sync(client=client, body=example.job).valid, example.name

    job.upper.shape.radius = -1.0
    problem = post_solve.sync(client=client, body=job)
    assert isinstance(problem, Problem) and problem.errors[0].pointer == "/upper/shape/radius", problem

    print(json.dumps({"peak_pressure": step.contact.peak_pressure, "approach": step.approach}))


if __name__ == "__main__":
    main()
