#!/usr/bin/env python3
"""Kills, stops and freezes the service under load; checks that no job is lost or doubled.

usage: tools/rounds.py [--rounds 9] [--store sqlite|postgres] [--binary target/release/brinell]

Jobs have small and large results, each with an announcement. `sqlite` is one service, `postgres`
two on a cluster of their own, which is restarted and cuts its connections too (needs initdb,
pg_ctl and psql). The receiver answers one announcement in five with 500. At the end every accepted
job must have succeeded, with a complete result and an announcement delivered under one id.
"""

import argparse, collections, http.client, http.server, json, random, shutil, signal
import subprocess, sys, tempfile, threading, time

from harness import EXAMPLES, Cluster, free_port

parser = argparse.ArgumentParser()
parser.add_argument("--rounds", type=int, default=9)
parser.add_argument("--seconds", type=float, default=4, help="of a round")
parser.add_argument("--store", choices=["sqlite", "postgres"], default="sqlite")
parser.add_argument("--binary", default="target/release/brinell")
args = parser.parse_args()
JOB = EXAMPLES["two_cylinders"]
SECRET = "whsec_" + "MfKQ9r8GKYqrTwjUPD8ILPZIo2LaLaSw"
random.seed(1)
data = tempfile.mkdtemp()
announced = collections.defaultdict(list)


class Receiver(http.server.BaseHTTPRequestHandler):
    def do_POST(self):
        notice = json.loads(self.rfile.read(int(self.headers["content-length"])))
        announced[notice["data"]["id"]].append(
            (self.headers["webhook-id"], notice["data"]["status"])
        )
        self.send_response(500 if random.random() < 0.2 else 204)
        self.send_header("Content-Length", "0")
        self.end_headers()

    def log_message(self, *_):
        pass


receiver = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Receiver)
threading.Thread(target=receiver.serve_forever, daemon=True).start()


class Node:
    """One service on a port that stays."""

    def __init__(self, store):
        self.port, self.store = free_port(), store
        self.start()

    def start(self):
        command = [
            args.binary,
            "serve",
            "--listen",
            f"127.0.0.1:{self.port}",
            *self.store,
            "--lease",
            "3",
            "--max-attempts",
            "100",
            # What is left to solve at the end.
            "--queue-capacity",
            "100",
            "--webhook-host",
            "127.0.0.1",
            "--webhook-secret",
            SECRET,
            "--webhook-allow-private",
            "--webhook-retry",
            "0.2",
        ]
        self.process = subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=open(f"{data}/log-{self.port}", "a"), text=True
        )
        self.process.stdout.readline()

    def end(self, how):
        self.process.send_signal(how)
        self.process.wait()
        self.start()

    def freeze(self, seconds):
        self.process.send_signal(signal.SIGSTOP)
        time.sleep(seconds)
        self.process.send_signal(signal.SIGCONT)


def ask(node, method, path, body=None, headers=()):
    connection = http.client.HTTPConnection("127.0.0.1", node.port, timeout=20)
    connection.request(method, path, body, {"Content-Type": "application/json", **dict(headers)})
    answer = connection.getresponse()
    return answer.status, answer.read()


accepted, stop = {}, threading.Event()


def submit(nodes, prefix):
    number = 0
    while not stop.is_set():
        number += 1
        is_large = number % 5 == 0
        job = {
            **JOB,
            "tags": {"number": f"{prefix}-{number}"},
            "mesh": {"elements_per_half_width": 20 if is_large else 4},
        }
        if is_large:
            job["load"], job["output"] = {"forces": [300, 400, 500]}, {"fields": True}
        path = f"/v1/jobs?callback_url=http://127.0.0.1:{receiver.server_port}/"
        while True:
            try:
                status, answer = ask(
                    random.choice(nodes),
                    "POST",
                    path,
                    json.dumps(job),
                    {"Idempotency-Key": f"{prefix}-{number}"},
                )
            except (OSError, http.client.HTTPException):
                status = 0
            if status in (200, 202):
                accepted[json.loads(answer)["id"]] = (f"{prefix}-{number}", 3 if is_large else 1)
                break
            if status not in (0, 429, 500, 503):
                sys.exit(f"{status} {answer}")
            time.sleep(0.1)
        time.sleep(0.02)


cluster = Cluster() if args.store == "postgres" else None
try:
    nodes = (
        [Node(["--database-url", cluster.url]) for _ in range(2)]
        if cluster
        else [Node(["--data-dir", f"{data}/jobs"])]
    )
    clients = [
        threading.Thread(target=submit, args=(nodes, prefix), daemon=True) for prefix in "ab"
    ]
    for client in clients:
        client.start()
    actions = {
        "kill": lambda: node.end(signal.SIGKILL),
        "stop": lambda: node.end(signal.SIGTERM),
        "freeze": lambda: node.freeze(5),
        **({"restart": cluster.restart, "cut": cluster.cut} if cluster else {}),
    }
    for number in range(args.rounds):
        time.sleep(args.seconds)
        action, node = list(actions)[number % len(actions)], nodes[number % len(nodes)]
        print(f"round {number + 1}: {action}, {len(accepted)} jobs accepted so far", flush=True)
        actions[action]()
    stop.set()
    for client in clients:
        client.join()
    begin = time.monotonic()
    faults = []
    for name, (tag, steps) in accepted.items():
        while True:
            document = json.loads(ask(nodes[0], "GET", f"/v1/jobs/{name}?wait=15")[1])
            if document["done"] and document["callback"]["state"] not in ("waiting", "pending"):
                break
            if time.monotonic() - begin > 900:
                sys.exit(f"still {document}")
            time.sleep(0.05)
        status, body = ask(nodes[0], "GET", f"/v1/jobs/{name}/result")
        result = json.loads(body) if status == 200 else {}
        if (
            document["status"] != "succeeded"
            or result.get("tags") != {"number": tag}
            or len(result.get("steps", [])) != steps
        ):
            faults.append(f"{name}: {document['status']}, {status}")
        if (
            document["callback"]["state"] != "delivered"
            or not announced[name]
            or len(set(announced[name])) != 1
        ):
            faults.append(f"{name}: {document['callback']}, announced {announced[name]}")
    names, cursor = [], ""
    while cursor is not None:
        page = json.loads(
            ask(nodes[0], "GET", f"/v1/jobs?limit=100{cursor and '&cursor=' + cursor}")[1]
        )
        names += [one["tags"]["number"] for one in page["jobs"]]
        cursor = page.get("next_cursor")
    twice = [name for name, count in collections.Counter(names).items() if count > 1]
    missing = {tag for tag, _ in accepted.values()} - set(names)
    repeated = sum(len(one) > 1 for one in announced.values())
    print(
        f"{args.store}: {len(accepted)} jobs accepted, {len(names)} there, {len(faults)} at fault, {len(twice)} twice, {len(missing)} missing; "
        f"{sum(map(len, announced.values()))} announcements, of {repeated} jobs more than one"
    )
    if faults or twice or missing:
        sys.exit(
            "\n".join([*faults[:10], f"twice {twice[:10]}", f"missing {sorted(missing)[:10]}"])
        )
finally:
    stop.set()
    for node in nodes:
        node.process.kill()
        node.process.wait()
    if cluster:
        cluster.stop()
    shutil.rmtree(data, ignore_errors=True)
