#!/usr/bin/env python3
"""Compares POST /v1/solve under load with the same jobs solved in a loop without a service.

usage: scripts/throughput.py [--elements 5 8] [--rounds 5] [--seconds 5] [-- MORE ARGUMENTS OF
            SERVE]

Needs wrk, `cargo build --release` and `cargo build --release -p brinell-tools --features service
--bin in_process`. The two are measured in turn, round by round; each row is the median of the
rounds. Three yield stresses of peak pressure, 64 connections.

Beside the rates by the clock, which other work on the machine disturbs, stand those by processor
time: jobs for each second of it that the loop took, and that server and wrk took together.
"""

import argparse, json, re, resource, statistics, subprocess, sys, tempfile, time
from pathlib import Path

parser = argparse.ArgumentParser()
parser.add_argument("--elements", type=int, nargs="+", default=[5, 8])
parser.add_argument("--rounds", type=int, default=5)
parser.add_argument("--seconds", type=int, default=5)
parser.add_argument("--connections", type=int, default=64)
parser.add_argument("--release", default="target/release")
parser.add_argument("serve", nargs="*")
args = parser.parse_args()

POST = """wrk.method = "POST"
wrk.headers["Content-Type"] = "application/json"
wrk.body = io.open("{job}"):read("*a")
"""


def processor_time():
    """Of all children that have ended [s]."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def in_process(job):
    """Jobs a second by the clock and by processor time."""
    before, begin = processor_time(), time.perf_counter()
    command = [f"{args.release}/in_process", str(job), str(args.seconds)]
    rate = float(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    return rate, rate * (time.perf_counter() - begin) / (processor_time() - before)


def service(job, folder):
    """Jobs a second by the clock and by processor time; latencies."""
    before = processor_time()
    lua = folder / "post.lua"
    lua.write_text(POST.format(job=job))
    command = [
        f"{args.release}/brinell",
        "serve",
        "--listen",
        "127.0.0.1:0",
        "--data-dir",
        str(folder / "data"),
        *args.serve,
    ]
    server = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    )
    try:
        url = "http://" + server.stdout.readline().split("//")[1].strip()
        load = [
            "wrk",
            "-t1",
            f"-c{args.connections}",
            f"-d{args.seconds}s",
            "--latency",
            "--timeout",
            "30s",
            "-s",
            str(lua),
            f"{url}/v1/solve",
        ]
        text = subprocess.run(load, check=True, capture_output=True, text=True).stdout
    finally:
        server.terminate()
        server.wait()
    if "Non-2xx" in text or "Socket errors" in text:
        sys.exit(text)
    latency = {share: value for share, value in re.findall(r"(50|99)%\s+([\d.]+m?s)", text)}
    rate, jobs = (
        float(re.search(r"Requests/sec:\s+([\d.]+)", text)[1]),
        int(re.search(r"(\d+) requests in", text)[1]),
    )
    return rate, jobs / (processor_time() - before), latency


for elements in args.elements:
    with tempfile.TemporaryDirectory(dir=".") as folder:
        folder = Path(folder).resolve()
        job = json.loads(Path("api/examples/two_cylinders.json").read_text())
        job["mesh"] = {"elements_per_half_width": elements}
        path = folder / "job.json"
        path.write_text(json.dumps(job))
        rows = []
        for number in range(args.rounds):
            alone, alone_cpu = in_process(path)
            served, served_cpu, latency = service(path, folder)
            rows.append(
                (alone, served, served / alone, alone_cpu, served_cpu, served_cpu / alone_cpu)
            )
            print(
                f"  {elements} elements, round {number + 1}: in process {alone:.1f}/s, served {served:.1f}/s; "
                f"by processor time {alone_cpu:.1f} and {served_cpu:.1f}; latency {latency}",
                flush=True,
            )
        alone, served, ratio, alone_cpu, served_cpu, ratio_cpu = (
            statistics.median(column) for column in zip(*rows)
        )
        print(
            f"{elements} elements: in process {alone:.1f} jobs/s, POST /v1/solve {served:.1f} jobs/s, "
            f"{100 * ratio:.1f} %; by processor time {alone_cpu:.1f} and {served_cpu:.1f}, {100 * ratio_cpu:.1f} % "
            f"(medians of {args.rounds})",
            flush=True,
        )
