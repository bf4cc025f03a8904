#!/usr/bin/env python3
"""Measures the waits of an API key while another key floods the service.

usage: tools/fair_share.py [--jobs 500] [--store sqlite|postgres] [--solvers 2] [--binary
            target/release/brinell] [-- MORE ARGUMENTS OF SERVE]

One key submits default jobs, half of them through POST /v1/solve and half through the queue at the
same time, first alone, then while another key floods both ways at priority 100 with default jobs,
sweeps of 200 loads at 60 elements and histories of 10 000 increments. Prints the waits of each
way, alone and beside the flood. Fails if the p99 beside the flood is above one second.
"""

import argparse, contextlib, http.client, json, statistics, subprocess, sys, threading, time

from harness import EXAMPLES, Cluster, Service, load

parser = argparse.ArgumentParser()
parser.add_argument("--jobs", type=int, default=500)
parser.add_argument("--store", choices=["sqlite", "postgres"], default="sqlite")
parser.add_argument("--solvers", type=int, default=2)
parser.add_argument("--binary", default="target/release/brinell")
parser.add_argument(
    "--connections", type=int, default=8, help="of the flood, each way and kind of job"
)
parser.add_argument("serve", nargs="*")
args = parser.parse_args()
JOB = EXAMPLES["two_cylinders"]
SWEEP = {
    **JOB,
    "mesh": {"elements_per_half_width": 60},
    "load": {"forces": [400 + step for step in range(200)]},
}
HISTORY = {**JOB, "solver": {"theory": "flow", "increments": 10_000}}


def ask(connection, token, method, path, body=None):
    headers = {"Content-Type": "application/json", "Authorization": f"Bearer {token}"}
    connection.request(method, path, body and json.dumps(body), headers)
    answer = connection.getresponse()
    return answer.status, answer.read()


def solve(connection, token):
    return ask(connection, token, "POST", "/v1/solve", JOB)[0] == 200


def queue(connection, token):
    # As a job of /v1/solve has it: of one key the higher goes first, so that its two ways would
    # hold each other up.
    status, receipt = ask(connection, token, "POST", "/v1/jobs?priority=1", JOB)
    if status != 202:
        return False
    job = json.loads(receipt)["id"]
    return (
        json.loads(ask(connection, token, "GET", f"/v1/jobs/{job}?wait=60")[1])["status"]
        == "succeeded"
    )


def client(host, token, way, waits):
    connection = http.client.HTTPConnection(host, timeout=120)
    for _ in range(args.jobs // 2):
        begin = time.monotonic()
        if not way(connection, token):
            print("a job of the modest key was not solved", file=sys.stderr)
        waits.append(time.monotonic() - begin)


def flood(host, token, path, job, end):
    connection = http.client.HTTPConnection(host, timeout=120)
    with contextlib.suppress(http.client.HTTPException, OSError):
        while not end.is_set():
            if ask(connection, token, "POST", path, job)[0] in (429, 503):
                time.sleep(0.1)  # The flood runs on the machine that it floods.


def p99(waits):
    return sorted(waits)[min(len(waits) - 1, len(waits) * 99 // 100)]


def round_of(host, token, greedy):
    waits, end = {solve: [], queue: []}, threading.Event()
    if greedy:
        for what in [
            (path, job)
            for job in (SWEEP, HISTORY, JOB)
            for path in ("/v1/jobs?priority=100", "/v1/solve")
        ] * args.connections:
            threading.Thread(target=flood, args=(host, greedy, *what, end), daemon=True).start()
    threads = [
        threading.Thread(target=client, args=(host, token, way, waits[way])) for way in waits
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    end.set()
    return waits


worst = 0
with Cluster() if args.store == "postgres" else contextlib.nullcontext() as cluster:
    flags = [
        "--require-api-key",
        "--queue-capacity-per-key",
        "1000",
        "--workers",
        str(args.solvers),
        *args.serve,
    ]
    with Service(args.binary, *flags, database=cluster and cluster.url) as service:
        modest, greedy = [
            subprocess.run(
                [args.binary, "key", "create", name, *service.store],
                check=True,
                capture_output=True,
                text=True,
            ).stdout.strip()
            for name in ("modest", "greedy")
        ]
        alone = round_of(service.host, modest, None)
        flooded = round_of(service.host, modest, greedy)
        for way in (solve, queue):
            a, b = alone[way], flooded[way]
            worst = max(worst, p99(b))
            print(
                f"{args.store}, {args.solvers} solvers, {way.__name__}: alone median {1e3 * statistics.median(a):.0f} ms, p99 {1e3 * p99(a):.0f} ms; beside the flood median "
                f"{1e3 * statistics.median(b):.0f} ms, p99 {1e3 * p99(b):.0f} ms of {len(b)}; {load()}",
                flush=True,
            )
        # What the flood has queued would take minutes.
        service.process.kill()
sys.exit(worst > 1)
