"""The service through httpx and the pydantic models of datamodel-code-generator."""

import sys

import httpx
from brinell_models import (
    Analysis,
    Bilinear,
    ContactBody,
    ContactJob,
    Cylinder,
    Deformable,
    ForceLoad,
    Job,
    JobList,
    Load,
    Material,
    OutputSettings,
    Plasticity,
    Problem,
    Report,
    Shape,
    Validation,
)
from uses import assert_csv, assert_events, assert_peak, assert_vtu


def reference_problem() -> ContactJob:
    """Two steel cylinders of 20 mm radius at three times their yield stress."""

    def cylinder() -> ContactBody:
        law = Bilinear(law="bilinear", yield_stress=500.0, tangent_modulus=10500.0)
        steel = Deformable(young_modulus=210000.0, poisson_ratio=0.3, plasticity=Plasticity(law))
        return ContactBody(shape=Shape(Cylinder(type="cylinder", radius=20.0)), material=Material(steel))

    load = Load(ForceLoad(force=612.6106))
    return ContactJob(analysis=Analysis.PLANE_STRAIN, upper=cylinder(), lower=cylinder(), load=load)


def main() -> None:
    http = httpx.Client(base_url=sys.argv[1], timeout=60.0)

    def post(path: str, job: ContactJob) -> httpx.Response:
        # A plain dump has null for everything that is left out: null is the same as nothing.
        return http.post(path, json=job.model_dump(mode="json"))

    job = reference_problem()
    assert Validation.model_validate(post("/v1/validate", job).json()).estimate.equations > 1000

    solved = Job.model_validate(post("/v1/solve", job).json())
    assert solved.result is not None and solved.result.status.root == "converged"
    assert_peak(solved.result.steps[0].answers)

    job.output = OutputSettings(fields=True)
    submitted = Job.model_validate(post("/v1/jobs", job).json())
    address = f"/v1/jobs/{submitted.id.root}"
    done = Job.model_validate(http.get(address, params={"wait": 60}).json())
    assert done.done and done.has_result
    result = Report.model_validate(http.get(f"{address}/result", params={"fields": "contact"}).json())
    assert_peak(result.steps[0].answers)

    jobs = JobList.model_validate(http.get("/v1/jobs", params={"limit": 10}).json())
    assert any(one.id == submitted.id for one in jobs.jobs)
    assert Job.model_validate(http.post(f"{address}/cancel").json()).done

    bad = job.model_dump(mode="json") | {"load": {"force": -1}}
    problem = Problem.model_validate(http.post("/v1/solve", json=bad).json())
    assert problem.errors is not None and problem.errors[0].pointer == "#/load/force"

    assert_events(http.get(f"{address}/events").text)
    assert_csv(http.get(f"{address}/summary.csv").text)
    assert_vtu(http.get(f"{address}/field.vtu").text)
    print("datamodel-code-generator: nine uses")


if __name__ == "__main__":
    main()
