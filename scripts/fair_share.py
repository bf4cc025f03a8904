#!/usr/bin/env python3
"""What one API key that floods the service does to two others.

usage: scripts/fair_share.py [--seconds 20] [--store sqlite|postgres] [--binary target/release/brinell] [-- MORE ARGUMENTS OF SERVE]
Two keys take turns with default jobs, one through POST /v1/solve, one through the
queue, first alone, then while a third floods both with everything it may: default jobs and sweeps that take minutes, at priority 100. Prints the waits of the two, and
their ratio, for each way.
"""
import argparse, contextlib, http.client, json, statistics, subprocess, sys, threading, time

from harness import EXAMPLES, Cluster, Service, load

parser = argparse.ArgumentParser()
parser.add_argument("--seconds", type=float, default=20)
parser.add_argument("--store", choices=["sqlite", "postgres"], default="sqlite")
parser.add_argument("--binary", default="target/release/brinell")
parser.add_argument("--connections", type=int, default=16, help="of the flood, each way")
parser.add_argument("serve", nargs="*")
args = parser.parse_args()
JOB = EXAMPLES["two_cylinders"]
SWEEP = {**JOB, "mesh": {"elements_per_half_width": 60}, "load": {"forces": [400 + step for step in range(200)]}}


def ask(connection, token, method, path, body=None):
    headers = {"Content-Type": "application/json", "Authorization": f"Bearer {token}"}
    connection.request(method, path, body and json.dumps(body), headers)
    answer = connection.getresponse()
    return answer.status, answer.read()


def solve(connection, token):
    status, _ = ask(connection, token, "POST", "/v1/solve", JOB)
    return status == 200


def queue(connection, token):
    status, receipt = ask(connection, token, "POST", "/v1/jobs", JOB)
    if status != 202:
        return False
    job = json.loads(receipt)["id"]
    status, document = ask(connection, token, "GET", f"/v1/jobs/{job}?wait=60")
    return json.loads(document)["status"] == "succeeded"


def client(host, token, way, until, waits):
    connection = http.client.HTTPConnection(host, timeout=120)
    while time.monotonic() < until:
        begin = time.monotonic()
        if not way(connection, token):
            sys.exit("a job of a modest key was not solved")
        waits.append(time.monotonic() - begin)


def flood(host, token, path, job, until):
    connection = http.client.HTTPConnection(host, timeout=120)
    try:
        while time.monotonic() < until:
            status, _ = ask(connection, token, "POST", path, job)
            if status == 429:
                time.sleep(0.1)  # The flood runs on the machine that it floods.
    except http.client.HTTPException:
        pass  # The service is ended while its last jobs are waited for.


def p99(waits):
    return sorted(waits)[min(len(waits) - 1, len(waits) * 99 // 100)]


def round_of(host, tokens, greedy):
    until = time.monotonic() + args.seconds
    waits = {solve: [], queue: []}
    threads = [threading.Thread(target=client, args=(host, token, way, until, waits[way]))
               for token, way in zip(tokens, waits)]
    if greedy:
        flood_with = [(path, job) for job in (SWEEP, JOB) for path in ("/v1/jobs?priority=100", "/v1/solve")] * args.connections
        threads += [threading.Thread(target=flood, args=(host, greedy, *what, until), daemon=True) for what in flood_with]
    for thread in threads:
        thread.start()
    for thread in threads[:2]:
        thread.join()
    return waits


with Cluster() if args.store == "postgres" else contextlib.nullcontext() as cluster:
    flags = ["--require-api-key", "--queue-capacity-per-key", "1000", *args.serve]
    with Service(args.binary, *flags, database=cluster and cluster.url) as service:
        tokens = [subprocess.run([args.binary, "key", "create", name, *service.store], check=True, capture_output=True, text=True).stdout.strip()
                  for name in ("solves", "queues", "floods")]
        alone = round_of(service.host, tokens[:2], None)
        flooded = round_of(service.host, tokens[:2], tokens[2])
        for way in (solve, queue):
            a, b = alone[way], flooded[way]
            print(f"{args.store}, {way.__name__}: alone median {1e3 * statistics.median(a):.0f} ms, p99 {1e3 * p99(a):.0f} ms of {len(a)}; flooded median "
                  f"{1e3 * statistics.median(b):.0f} ms, p99 {1e3 * p99(b):.0f} ms of {len(b)}; p99 {p99(b) / p99(a):.2f} times; {load()}", flush=True)
        # What the flood has queued would take minutes.
        service.process.kill()
