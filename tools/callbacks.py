#!/usr/bin/env python3
"""Measures the cost of announcements: jobs a second on PostgreSQL with and without a callback.

usage: tools/callbacks.py [--jobs 600] [--rounds 3] [--binary target/release/brinell]

Also prints the work of the database for each job. Rounds with and without a callback alternate.
Jobs of 4 elements are queued first and then timed from the first start to the last end.
"""

import argparse, http.server, statistics, subprocess, threading
from datetime import datetime

from harness import EXAMPLES, Cluster, Service, load

parser = argparse.ArgumentParser()
parser.add_argument("--jobs", type=int, default=600)
parser.add_argument("--rounds", type=int, default=3)
parser.add_argument("--binary", default="target/release/brinell")
args = parser.parse_args()
JOB = {**EXAMPLES["two_cylinders"], "mesh": {"elements_per_half_width": 4}}


class Receiver(http.server.BaseHTTPRequestHandler):
    def do_POST(self):
        self.rfile.read(int(self.headers["content-length"]))
        self.send_response(204)
        self.end_headers()

    def log_message(self, *_):
        pass


receiver = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Receiver)
threading.Thread(target=receiver.serve_forever, daemon=True).start()
callback = f"?callback_url=http://127.0.0.1:{receiver.server_port}/"


def rate(service, query):
    batch = {"jobs": [{"job": JOB, **({"callback_url": callback[14:]} if query else {})}] * 100}
    names = [
        one["job"]["id"]
        for _ in range(args.jobs // 100)
        for one in service.ask("POST", "/v1/batch/submit", batch)[1]["jobs"]
    ]
    documents = [service.wait(name) for name in names]
    times = [
        [datetime.fromisoformat(one[name]) for one in documents]
        for name in ("started_at", "finished_at")
    ]
    return len(names) / (max(times[1]) - min(times[0])).total_seconds()


with Cluster() as cluster:

    def ask(statement):
        return subprocess.run(
            ["psql", cluster.url, "-Atc", statement], check=True, capture_output=True, text=True
        ).stdout.strip()

    ask("ALTER SYSTEM SET shared_preload_libraries = 'pg_stat_statements'")
    cluster.restart()
    ask("CREATE EXTENSION pg_stat_statements")
    flags = [
        "--webhook-host",
        "127.0.0.1",
        "--webhook-secret",
        "whsec_" + "MfKQ9r8GKYqrTwjUPD8ILPZIo2LaLaSw",
        "--webhook-allow-private",
    ]
    with Service(args.binary, *flags, database=cluster.url) as service:
        without, with_callback = [], []
        for _ in range(args.rounds):
            ask("SELECT pg_stat_statements_reset()")
            without.append(rate(service, ""))
            total = float(ask("SELECT sum(total_exec_time) FROM pg_stat_statements"))
            calls = int(ask("SELECT sum(calls) FROM pg_stat_statements"))
            own = ask(
                "SELECT calls, total_exec_time FROM pg_stat_statements WHERE query LIKE '%UPDATE deliveries%finished_at FROM jobs%'"
            )
            with_callback.append(rate(service, callback))
        number, spent = own.split("|")
        print(
            f"without a callback {statistics.median(without):.1f} jobs/s, with one {statistics.median(with_callback):.1f} (medians of {args.rounds}, {load()})"
        )
        print(
            f"without: {calls / args.jobs:.1f} statements a job, {total / args.jobs:.2f} ms of the database; of these for announcements "
            f"{int(number) / args.jobs:.1f} and {float(spent) / args.jobs:.3f} ms"
        )
