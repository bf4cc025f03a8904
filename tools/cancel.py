#!/usr/bin/env python3
"""Measures how long large jobs continue after a request to stop, through the service.

usage: tools/cancel.py [--elements 220] [--times 6] [--course 30] [--binary
            target/release/brinell]

Jobs of two different bodies with every output, of each analysis, theory and coupling, are
cancelled at times spread over their duration, or over `--course` seconds of it. Prints the longest
and the median time from the request to the final state, and fails above 0.5 s.
"""

import argparse, statistics, sys, time

from harness import EXAMPLES, Service, load

parser = argparse.ArgumentParser()
parser.add_argument("--elements", type=int, default=220)
parser.add_argument("--times", type=int, default=6)
parser.add_argument("--course", type=float, default=30)
parser.add_argument("--only", nargs="+", default=[])
parser.add_argument("--binary", default="target/release/brinell")
args = parser.parse_args()
BASE = {
    **EXAMPLES["two_cylinders"],
    "mesh": {"elements_per_half_width": args.elements},
    "output": {"fields": True, "subsurface": True},
}
BASE["lower"] = {
    **BASE["lower"],
    "material": {
        **BASE["lower"]["material"],
        "plasticity": {**BASE["lower"]["material"]["plasticity"], "yield_stress": 501.0},
    },
}
HISTORY = {
    "solver": {"theory": "flow"},
    "load": {"history": [{"force": 300.0}, {"force": 612.0}, {"force": 0.0}]},
}
JOBS = {
    "accelerated": {},
    "strong": {"solver": {"coupling": "strong"}},
    "weak": {"solver": {"coupling": "weak"}},
    "secant stiffness": {"solver": {"coupling": "secant_stiffness"}},
    "plane stress": {"analysis": "plane_stress"},
    "axisymmetric": {"analysis": "axisymmetric", "load": {"force": 3000.0}},
    "flow theory": HISTORY,
}

worst = 0.0
print(
    f"{args.elements} elements, {load()}\n\n| job | course [s] | median [s] | longest [s] |\n|---|--:|--:|--:|"
)
with Service(
    args.binary,
    "--workers",
    "1",
    "--factor-cache",
    "0",
    "--max-job-memory",
    "16384",
    "--memory-limit",
    "16384",
) as service:
    for title, more in JOBS.items():
        if args.only and title not in args.only:
            continue
        job, waits, state = {**BASE, **more}, [], ""

        def cancelled(name):
            begin = time.perf_counter()
            service.ask("POST", f"/v1/jobs/{name}/cancel")
            document = service.wait(name)
            return time.perf_counter() - begin, document["status"]

        begin = time.perf_counter()
        name = service.submit(job)
        if not service.wait(name, args.course)["done"]:
            waits.append(cancelled(name)[0])
        course = time.perf_counter() - begin
        for number in range(1, args.times + 1):
            name = service.submit(job)
            while service.ask("GET", f"/v1/jobs/{name}")[1]["status"] == "queued":
                time.sleep(0.01)
            time.sleep(course * number / (args.times + 1))
            wait, state = cancelled(name)
            if state == "cancelled":
                waits.append(wait)
        worst = max([worst, *waits])
        print(
            f"| {title} | {course:.1f} | {statistics.median(waits):.3f} | {max(waits):.3f} |",
            flush=True,
        )
print(f"\nlongest {worst:.3f} s, {load()}")
sys.exit(worst >= 0.5)
