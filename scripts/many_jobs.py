#!/usr/bin/env python3
"""Hands 10 000 jobs to `brinell serve`, waits for all, checks each and reports rates and the server's memory.

usage: scripts/many_jobs.py [--jobs N] [--large N] [--binary target/release/brinell] [-- MORE ARGUMENTS OF SERVE]
Needs nothing but Python. Prints one line each for submission, solving and memory (RSS at the start, once all are queued, after each
tenth of them, and after all results were fetched). With `--large` so many of the jobs, spread over the others, have 200 MB of fields; answers other than
those expected, 503 among them, end the run.
"""
import argparse, http.client, json, re, subprocess, sys, tempfile, threading, time

parser = argparse.ArgumentParser()
parser.add_argument("--jobs", type=int, default=10_000)
parser.add_argument("--elements", type=int, default=4)
parser.add_argument("--large", type=int, default=0, help="further jobs with large results")
parser.add_argument("--megabytes", type=float, default=200, help="fields of each of these")
parser.add_argument("--binary", default="target/release/brinell")
parser.add_argument("serve", nargs="*")
args = parser.parse_args()


def rss(pid):
    with open(f"/proc/{pid}/status") as status:
        return int(re.search(r"VmRSS:\s+(\d+)", status.read())[1]) / 1024


def ask(connection, method, path, body=None):
    connection.request(method, path, body, {"Content-Type": "application/json"})
    answer = connection.getresponse()
    return answer.status, json.loads(answer.read())


job = json.load(open("api/examples/two_cylinders.json"))
job["mesh"] = {"elements_per_half_width": args.elements}
# A step has about 7 MB of fields.
steps = max(1, round(args.megabytes / 7))
large = {**job, "mesh": {"elements_per_half_width": 50}, "output": {"fields": True}, "load": {"forces": [400 + 5 * step for step in range(steps)]}}

with tempfile.TemporaryDirectory() as data:
    command = [args.binary, "serve", "--listen", "127.0.0.1:0", "--data-dir", data, "--queue-capacity",
               str(args.jobs + args.large), *args.serve]
    server = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    try:
        host = server.stdout.readline().split("//")[1].strip()
        connection = http.client.HTTPConnection(host)
        memory, latencies, done = [rss(server.pid)], [], threading.Event()

        def poll(job_id):
            own = http.client.HTTPConnection(host)
            while not done.is_set():
                begin = time.perf_counter()
                status, _ = ask(own, "GET", f"/v1/jobs/{job_id}")
                assert status == 200, status
                latencies.append(time.perf_counter() - begin)
                time.sleep(0.005)

        begin, ids, larges = time.perf_counter(), [], []
        for number in range(args.jobs):
            if args.large and number % max(1, args.jobs // args.large) == 0 and len(larges) < args.large:
                status, receipt = ask(connection, "POST", "/v1/jobs", json.dumps(large))
                assert status == 202, receipt
                larges.append(receipt["id"])
            job["tags"] = {"number": str(number)}
            status, receipt = ask(connection, "POST", "/v1/jobs", json.dumps(job))
            assert status == 202, receipt
            ids.append(receipt["id"])
        submitted = time.perf_counter() - begin
        tenths = 0
        watcher = threading.Thread(target=poll, args=(ids[-1],))
        watcher.start()
        while True:
            queue = ask(connection, "GET", "/v1/capacity")[1]["queue"]
            left = queue["queued"] + queue["running"]
            if left <= args.jobs * (1 - tenths / 10):
                memory.append(rss(server.pid))
                tenths += 1
            if left == 0:
                break
            time.sleep(0.1)
        solved = time.perf_counter() - begin
        done.set()
        watcher.join()
        for number, name in enumerate(ids):
            status, report = ask(connection, "GET", f"/v1/jobs/{name}/result")
            assert status == 200 and report["status"] == "converged", (name, status)
            assert report["tags"]["number"] == str(number)
        size = 0
        for name in larges:
            for step in range(1, steps + 1):
                connection.request("GET", f"/v1/jobs/{name}/fields/{step}", headers={"Accept-Encoding": "identity"})
                answer = connection.getresponse()
                assert answer.status == 200, answer.status
                size += len(answer.read())
        memory.append(rss(server.pid))
        latencies.sort()
        print(f"submitted {args.jobs} jobs in {submitted:.1f} s, {args.jobs / submitted:.0f} a second")
        print(f"all solved and fetched after {solved:.1f} s, {args.jobs / solved:.0f} a second")
        if larges:
            print(f"and {len(larges)} jobs with fields, {2 * size / len(larges) / 1e6:.0f} MB of them in the store each (in double precision)")
        print("memory (MiB): " + " / ".join(f"{value:.0f}" for value in memory))
        print(f"GET /v1/jobs/ID meanwhile: median {1e3 * latencies[len(latencies) // 2]:.1f} ms, "
              f"p99 {1e3 * latencies[len(latencies) * 99 // 100]:.1f} ms of {len(latencies)}")
    finally:
        server.terminate()
        print("exit code", server.wait(), file=sys.stderr)
