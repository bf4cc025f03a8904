#!/usr/bin/env python3
"""What jobs are estimated to need, and what they take: memory and result, over a table of jobs.

usage: scripts/estimates.py [--binary target/release/brinell] [--largest 160]
Each job is solved by a service of its own, with one worker and nothing kept between jobs; its memory is the process's largest less what it had
after a small one. Prints a table in Markdown and fails where a job takes more than 1.2 times its estimate.
"""
import argparse, json, sqlite3, sys

from harness import EXAMPLES, Service

parser = argparse.ArgumentParser()
parser.add_argument("--binary", default="target/release/brinell")
parser.add_argument("--largest", type=int, default=160)
args = parser.parse_args()


def job(example, elements, forces=None, fields=False, **more):
    made = {**EXAMPLES[example], "mesh": {"elements_per_half_width": elements}, "output": {"fields": fields, "subsurface": True}, **more}
    if forces:
        made["load"] = {"forces": [300 + 10 * step for step in range(forces)]}
    return made


def different(made):
    made = json.loads(json.dumps(made))
    made["lower"]["material"]["plasticity"]["yield_stress"] = 501.0
    return made


TABLE = [("equal bodies", job("two_cylinders", 20)), ("equal bodies", job("two_cylinders", 80)),
         ("equal bodies, fields", job("two_cylinders", 80, fields=True)),
         ("different bodies, fields", different(job("two_cylinders", 80, fields=True))),
         ("40 loads, fields", job("two_cylinders", 80, 40, True)), ("1000 loads, fields", job("two_cylinders", 5, 1000, True)),
         ("secant stiffness", job("two_cylinders", 40, solver={"coupling": "secant_stiffness"})),
         ("flow theory, fields", {**job("two_cylinders", 20, fields=True), "solver": {"theory": "flow"}, "load": {"history": [{"force": 300.0}, {"force": 612.0}, {"force": 0.0}]}}),
         *[(name.replace("_", " "), {**example, "output": {"fields": True}}) for name, example in EXAMPLES.items()],
         ("different bodies, fields", different(job("two_cylinders", args.largest, fields=True)))]


print("| job | elements | equations | estimate [MiB] | peak [MiB] | ratio | result, estimate [MiB] | result [MiB] | ratio |")
print("|---|--:|--:|--:|--:|--:|--:|--:|--:|")
worst = 0.0
for name, made in TABLE:
    with Service(args.binary, "--workers", "1", "--factor-cache", "0", "--max-job-memory", "16384", "--memory-limit", "16384") as service:
        code, answer = service.ask("POST", "/v1/validate", made)
        estimate = answer["estimate"] if code == 200 else sys.exit(f"{name}: {answer}")
        # What the process takes for its first job whatever that is.
        service.wait(service.submit(job("two_cylinders", 4, fields=True)))
        before = service.memory()
        document = service.wait(service.submit(made))
        peak = service.memory("VmHWM") - before
        with sqlite3.connect(f"file:{service.data}/brinell.db?mode=ro", uri=True) as database:
            stored = database.execute("SELECT stored_bytes FROM jobs ORDER BY id DESC").fetchone()[0]
    if document["status"] not in ("succeeded", "not_converged"):
        sys.exit(f"{name}: {document['status']}")
    ratio, size = peak / estimate["bytes"], stored / estimate["result_bytes"]
    worst = max(worst, ratio, size)
    mesh = made.get("mesh", {}).get("elements_per_half_width", "")
    print(f"| {name} | {mesh} | {estimate['equations']} | {estimate['bytes'] / 2**20:.0f} | {peak / 2**20:.0f} | {ratio:.2f} | "
          f"{estimate['result_bytes'] / 2**20:.2f} | {stored / 2**20:.2f} | {size:.2f} |", flush=True)
sys.exit(f"the worst is {worst:.2f} times its estimate" if worst > 1.2 else 0)
