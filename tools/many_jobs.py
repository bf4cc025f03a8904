#!/usr/bin/env python3
"""Submits 10 000 jobs to `brinell serve`, checks each result and prints rates and memory.

usage: tools/many_jobs.py [--jobs N] [--large N] [--binary target/release/brinell] [-- MORE
            ARGUMENTS OF SERVE]

Needs only Python. Prints a line each for submission, solving and memory (RSS at the start, once
all jobs are queued, after each tenth of them, and after all results were fetched). `--large N`
adds N jobs with 200 MB of fields, spread over the others. An unexpected answer, such as 503, ends
the run.
"""

import argparse, threading, time

from harness import EXAMPLES, Service, load

parser = argparse.ArgumentParser()
parser.add_argument("--jobs", type=int, default=10_000)
parser.add_argument("--elements", type=int, default=4)
parser.add_argument("--large", type=int, default=0, help="further jobs with large results")
parser.add_argument("--megabytes", type=float, default=200, help="fields of each of these")
parser.add_argument("--binary", default="target/release/brinell")
parser.add_argument("serve", nargs="*")
args = parser.parse_args()


job = {**EXAMPLES["two_cylinders"], "mesh": {"elements_per_half_width": args.elements}}
# A step has about 7 MB of fields.
steps = max(1, round(args.megabytes / 7))
large = {
    **job,
    "mesh": {"elements_per_half_width": 50},
    "output": {"fields": True},
    "load": {"forces": [400 + 5 * step for step in range(steps)]},
}
print(load())

with Service(args.binary, "--queue-capacity", str(args.jobs + args.large), *args.serve) as service:
    memory, latencies, done = [service.memory()], [], threading.Event()

    def poll(job_id):
        own = service.connect()
        while not done.is_set():
            begin = time.perf_counter()
            status, _ = service.ask("GET", f"/v1/jobs/{job_id}", connection=own)
            assert status == 200, status
            latencies.append(time.perf_counter() - begin)
            time.sleep(0.005)

    begin, ids, larges = time.perf_counter(), [], []
    for number in range(args.jobs):
        if (
            args.large
            and number % max(1, args.jobs // args.large) == 0
            and len(larges) < args.large
        ):
            larges.append(service.submit(large))
        ids.append(service.submit({**job, "tags": {"number": str(number)}}))
    submitted = time.perf_counter() - begin
    tenths = 0
    watcher = threading.Thread(target=poll, args=(ids[-1],))
    watcher.start()
    while True:
        queue = service.ask("GET", "/v1/capacity")[1]["queue"]
        left = queue["queued"] + queue["running"]
        if left <= args.jobs * (1 - tenths / 10):
            memory.append(service.memory())
            tenths += 1
        if left == 0:
            break
        time.sleep(0.1)
    solved = time.perf_counter() - begin
    done.set()
    watcher.join()
    for number, name in enumerate(ids):
        status, report = service.ask("GET", f"/v1/jobs/{name}/result")
        assert status == 200 and report["status"] == "converged", (name, status)
        assert report["tags"]["number"] == str(number)
    size = 0
    for name in larges:
        for step in range(1, steps + 1):
            status, arrays = service.ask("GET", f"/v1/jobs/{name}/fields/{step}")
            assert status == 200, status
            size += len(arrays)
    memory.append(service.memory())
    latencies.sort()
    print(f"submitted {args.jobs} jobs in {submitted:.1f} s, {args.jobs / submitted:.0f} a second")
    print(f"all solved and fetched after {solved:.1f} s, {args.jobs / solved:.0f} a second")
    if larges:
        print(
            f"and {len(larges)} jobs with fields, {2 * size / len(larges) / 1e6:.0f} MB of them in the store each (in double precision)"
        )
    print("memory (MiB): " + " / ".join(f"{value >> 20}" for value in memory))
    print(
        f"GET /v1/jobs/ID meanwhile: median {1e3 * latencies[len(latencies) // 2]:.1f} ms, "
        f"p99 {1e3 * latencies[len(latencies) * 99 // 100]:.1f} ms of {len(latencies)}"
    )
