"""Measures the time to a first picture and the throughput of a sweep.

BRINELL_PROGRAM=target/release/brinell python clients/python/scripts/measure.py
"""

import os
import subprocess
import sys
import time
from datetime import datetime

import numpy as np

import brinell
from brinell._plain import document_of

MEMBERS = 200

FIRST_PICTURE = """
import time
before = time.perf_counter()
import brinell
imported = time.perf_counter()
client = brinell.Client()
steel = brinell.material(
    young_modulus=210000,
    poisson_ratio=0.3,
    plasticity=brinell.bilinear(yield_stress=500, tangent_modulus=10500),
)
roller = brinell.cylinder(radius=20, material=steel)
job = brinell.job(roller, roller, analysis="plane_strain", force=612.6106)
result = client.solve(job)
ax = result.plot.pressure()
ax.figure.savefig("/dev/null", format="png")
drawn = time.perf_counter()
print(f"import {imported - before:.2f} s, then to a picture {drawn - imported:.2f} s")
"""


def jobs() -> list[brinell.JobLike]:
    def roller(yield_stress: float) -> object:
        law = brinell.bilinear(yield_stress=yield_stress, tangent_modulus=10500)
        steel = brinell.material(young_modulus=210000, poisson_ratio=0.3, plasticity=law)
        return brinell.cylinder(radius=20, material=steel)

    loads = [(f, y) for f in np.linspace(300, 700, MEMBERS // 4) for y in (400, 450, 500, 550)]
    return [
        brinell.job(roller(y), roller(y), analysis="plane_strain", force=float(f))
        for f, y in loads
    ]


def moment(text: str) -> datetime:
    """A moment in UTC, to the microsecond: more digits than 3.10 reads are cut off."""
    whole, _, part = text.removesuffix("Z").partition(".")
    return datetime.fromisoformat(f"{whole}.{part[:6]:0<6}")


def own_workers(members: list[brinell.JobLike]) -> float:
    """From the first to the last job by the program's own clock, all queued at once."""
    with brinell.Client() as client:
        handles = []
        for start in range(0, MEMBERS, 100):
            batch = [{"job": document_of(job)} for job in members[start : start + 100]]
            answer = client._run(
                client._core.json("POST", "/v1/batch/submit", body={"jobs": batch})
            )
            handles += [client.job(item["job"]["id"]) for item in answer["jobs"]]
        while not all(handle.wait(60) for handle in reversed(handles)):
            pass
        infos = [handle.info for handle in handles]
        starts = [moment(info["started_at"]) for info in infos]
        ends = [moment(info["finished_at"]) for info in infos]
        return (max(ends) - min(starts)).total_seconds()


def by_sweep(members: list[brinell.JobLike]) -> float:
    with brinell.Client() as client:
        begin = time.perf_counter()
        table = client.sweep(lambda place: members[place], {"place": range(MEMBERS)})
        seconds = time.perf_counter() - begin
    assert (table["status"] == "converged").all()
    return seconds


def main() -> None:
    for _ in range(3):
        environment = {**os.environ, "MPLBACKEND": "agg"}
        subprocess.run([sys.executable, "-c", FIRST_PICTURE], check=True, env=environment)
    members = jobs()
    for _ in range(3):
        own, sweep = own_workers(members), by_sweep(members)
        print(
            f"{MEMBERS} jobs: {own:.2f} s by the program's workers, {sweep:.2f} s by sweep: "
            f"{100 * own / sweep:.0f} % of their throughput"
        )


if __name__ == "__main__":
    main()
