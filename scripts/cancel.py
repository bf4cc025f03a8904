#!/usr/bin/env python3
"""How long a large job goes on after it was asked to stop.

usage: scripts/cancel.py [--elements 220] [--times 12] [--binary target/release/brinell]
Solves a job of two different bodies with every output once, then again and again, and cancels it at moments spread over its course. Prints how
long each took from the request to the final state, and the longest.
"""
import argparse, http.client, json, subprocess, sys, tempfile, time
from pathlib import Path

parser = argparse.ArgumentParser()
parser.add_argument("--elements", type=int, default=220)
parser.add_argument("--times", type=int, default=12)
parser.add_argument("--binary", default="target/release/brinell")
args = parser.parse_args()
job = json.loads(Path("api/examples/two_cylinders.json").read_text())
job["mesh"] = {"elements_per_half_width": args.elements}
job["lower"]["material"]["plasticity"]["yield_stress"] = 501.0
job["output"] = {"fields": True, "subsurface": True}


def ask(connection, method, path, body=None):
    connection.request(method, path, body, {"Content-Type": "application/json"})
    answer = connection.getresponse()
    return json.loads(answer.read())


def until(connection, name, state):
    while True:
        document = ask(connection, "GET", f"/v1/jobs/{name}?wait=60")
        if document["status"] == state or document["done"]:
            return document


with tempfile.TemporaryDirectory() as data:
    command = [args.binary, "serve", "--listen", "127.0.0.1:0", "--data-dir", data, "--workers", "1", "--factor-cache", "0",
               "--max-job-memory", "16384", "--memory-limit", "16384"]
    server = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    try:
        connection = http.client.HTTPConnection(server.stdout.readline().split("//")[1].strip(), timeout=600)
        begin = time.perf_counter()
        receipt = ask(connection, "POST", "/v1/jobs", json.dumps(job))
        assert "id" in receipt, receipt
        whole = until(connection, receipt["id"], "succeeded")
        course = time.perf_counter() - begin
        print(f"{args.elements} elements: {whole['status']} after {course:.1f} s")
        waits = []
        for number in range(1, args.times + 1):
            name = ask(connection, "POST", "/v1/jobs", json.dumps(job))["id"]
            while ask(connection, "GET", f"/v1/jobs/{name}")["status"] == "queued":
                time.sleep(0.01)
            moment = course * number / (args.times + 1)
            time.sleep(moment)
            begin = time.perf_counter()
            ask(connection, "POST", f"/v1/jobs/{name}/cancel")
            ended = until(connection, name, "cancelled")
            waits.append(time.perf_counter() - begin)
            print(f"  asked at {moment:5.1f} s: {ended['status']} after {waits[-1]:.3f} s", flush=True)
        print(f"longest {max(waits):.3f} s")
    finally:
        server.terminate()
        print("exit code", server.wait(), file=sys.stderr)
