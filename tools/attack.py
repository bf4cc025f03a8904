#!/usr/bin/env python3
"""Attacks `brinell serve` with many hostile clients and measures the waits of another client.

usage: tools/attack.py [--only NAME ...] [--connections 4500] [--binary target/release/brinell]

Each attack has a service of its own. Meanwhile another client requests `GET /v1/jobs/{id}` two
hundred times. Prints the median and the 99th percentile of its waits, the memory of the service
before and its largest value, and the time that the service takes to end on SIGTERM with the
attackers still connected. The exit code is 1 if a request of the other client fails, if the memory
exceeds its bound, or if the service does not end by itself.
"""

import argparse, http.client, resource, socket, subprocess, sys, threading, time
from pathlib import Path

from harness import EXAMPLES, Service, load

parser = argparse.ArgumentParser()
parser.add_argument("--only", nargs="+", default=[])
parser.add_argument(
    "--connections", type=int, default=4500, help="of the attackers, where they need only be many"
)
parser.add_argument("--binary", default="target/release/brinell")
args = parser.parse_args()
limit = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
resource.setrlimit(resource.RLIMIT_NOFILE, (min(limit, 16384), limit))
JOB = EXAMPLES["two_cylinders"]
SMALL = {**JOB, "mesh": {"elements_per_half_width": 5}}
LARGE = {**JOB, "mesh": {"elements_per_half_width": 80}, "output": {"fields": True}}
LONG = {
    **JOB,
    "mesh": {"elements_per_half_width": 60},
    "load": {"forces": [400 + step for step in range(500)]},
}
SWEEP = {
    **JOB,
    "mesh": {"elements_per_half_width": 10},
    "load": {"forces": [300 + step for step in range(400)]},
}
failures = []


class Attacked(Service):
    def __init__(self, *flags):
        super().__init__(args.binary, "--grace", "12", *flags)
        self.sockets = []

    def job(self, job):
        name = self.submit(job)
        self.wait(name)
        # The most from here on counts, not what solving has taken.
        Path(f"/proc/{self.process.pid}/clear_refs").write_text("5")
        return name

    def attack(self, text=b"", small=False):
        """A connection of an attacker, on which this much was said."""
        one = socket.socket()
        if small:
            one.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        one.settimeout(5)
        self.sockets.append(one)
        try:
            address, port = self.host.split(":")
            one.connect((address, int(port)))
            one.sendall(text)
        except OSError:
            pass
        one.setblocking(False)
        return one

    def end(self):
        """How the process ends while all attackers are still there, and how long that takes."""
        begin = time.monotonic()
        self.process.terminate()
        try:
            code = self.process.wait(40)
        except subprocess.TimeoutExpired:
            self.process.kill()
            code = "does not end"
        taken = time.monotonic() - begin
        for one in self.sockets:
            one.close()
        return code, taken


def head(path, method="GET", more=""):
    return f"{method} {path} HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n{more}\r\n".encode()


def silent(service):
    """Connections on which nothing is said."""
    for _ in range(args.connections):
        service.attack()


def slow_heads(service):
    """Heads that come byte by byte."""
    many = [
        service.attack(b"GET /v1/jobs HTTP/1.1\r\nHost: localhost\r\nX-Slow: ")
        for _ in range(args.connections)
    ]
    return lambda: [send(one, b"a") for one in many]


def slow_bodies(service):
    """Bodies of the largest size that come byte by byte."""
    many = [
        service.attack(head("/v1/solve", "POST", "Content-Length: 1048576\r\n") + b" " * 20000)
        for _ in range(1000)
    ]
    return lambda: [send(one, b" ") for one in many]


def waits(service):
    """Clients that wait for one job, for as long as they may."""
    slow = service.submit(LONG)
    for _ in range(3000):
        service.attack(head(f"/v1/jobs/{slow}?wait=60"))


def event_streams(service):
    """Readers of events, more than there are places."""
    slow = service.submit(LONG)
    for _ in range(1500):
        service.attack(head(f"/v1/jobs/{slow}/events"))


def deaf_followers(service):
    """Readers of the events of a job with a long history, who take nothing."""
    history = {**SMALL, "solver": {"theory": "flow", "increments": 1000}}
    job = service.job(history)
    for _ in range(400):
        service.attack(head(f"/v1/jobs/{job}/events"), small=True)


def deaf_readers(path, job=LARGE):
    def attack(service):
        large = service.job(job)
        service.path = f"/v1/jobs/{large}{path}"
        many = [service.attack(head(service.path), small=True) for _ in range(200)]
        return lambda: [receive(one) for one in many]

    attack.__doc__ = f"Readers of {path} of a large job that take a few bytes a second."
    return attack


def solvers(service):
    """Twelve clients that loop over /v1/solve with the largest job that may be."""
    over = threading.Event()

    def ask():
        while not over.is_set():
            service.ask(
                "POST",
                "/v1/solve?wait=5",
                {**JOB, "mesh": {"elements_per_half_width": 120}},
                service.connect(30),
            )

    for _ in range(12):
        threading.Thread(target=quiet(ask), daemon=True).start()
    service.over = over


def checks(service):
    """Sweeps of a thousand loads that are checked and not solved, on 32 connections."""
    over = threading.Event()
    sweep = {**JOB, "load": {"forces": [400 + step for step in range(1000)]}}

    def ask():
        connection = service.connect(30)
        while not over.is_set():
            service.ask("POST", "/v1/validate", sweep, connection)

    for _ in range(32):
        threading.Thread(target=quiet(ask), daemon=True).start()
    service.over = over


def checks_of_keys(service):
    """The same of 40 keys, each on a connection of its own."""
    over = threading.Event()
    sweep = {**JOB, "load": {"forces": [400 + step for step in range(1000)]}}
    create = [args.binary, "key", "create", *service.store]

    def ask(token):
        connection = service.connect(30)
        while not over.is_set():
            service.ask("POST", "/v1/validate", sweep, connection, Authorization=f"Bearer {token}")

    for number in range(40):
        token = subprocess.run(
            [*create, str(number)], check=True, capture_output=True, text=True
        ).stdout.strip()
        threading.Thread(target=quiet(lambda token=token: ask(token)), daemon=True).start()
    service.over = over


def requests_without_answers(service):
    """Thousands of requests on one connection, no answer of which is read."""
    for _ in range(200):
        service.attack(head("/openapi.json") * 2000, small=True)


ATTACKS = {
    "silent": silent,
    "slow heads": slow_heads,
    "slow bodies": slow_bodies,
    "waits": waits,
    "event streams": event_streams,
    "deaf followers": deaf_followers,
    "deaf readers of results": deaf_readers("/result"),
    "deaf readers of arrays": deaf_readers("/fields/1"),
    "deaf readers of VTK files": deaf_readers("/field.vtu"),
    "deaf readers of tables": deaf_readers("/pressure.csv", SWEEP),
    "solvers": solvers,
    "checks": checks,
    "checks of 40 keys": checks_of_keys,
    "requests without answers": requests_without_answers,
}


def quiet(what):
    def run():
        try:
            what()
        except (OSError, http.client.HTTPException):
            pass  # The service ends while they are at it.

    return run


def send(one, text):
    try:
        one.send(text)
    except OSError:
        pass


def receive(one):
    try:
        one.recv(100)
    except OSError:
        pass


def go_on(step, over):
    while not over.wait(1):
        step()


def wait_of(service, path, connection):
    """Milliseconds until an answer, and what is wrong with it."""
    begin = time.perf_counter()
    try:
        status, _ = service.ask("GET", path, connection=connection)
        fault = None if status == 200 else f"{path}: {status}"
    except (OSError, http.client.HTTPException) as error:
        connection.close()
        fault = f"{path}: {error!r}"
    return 1e3 * (time.perf_counter() - begin), fault


def run(attack):
    with Attacked("--max-connections", str(args.connections + 500)) as service:
        own = service.job(SMALL)
        before, over = service.memory(), threading.Event()
        if step := attack(service):
            threading.Thread(target=go_on, args=(step, over), daemon=True).start()
        time.sleep(1)
        connection, waits, faults = service.connect(30), [], []
        for _ in range(200):
            wait, fault = wait_of(service, f"/v1/jobs/{own}", connection)
            waits.append(wait)
            faults.append(fault)
            time.sleep(0.02)
        for path in (
            [service.path, f"/v1/jobs/{own}/pressure.svg"] if hasattr(service, "path") else []
        ):
            wait, fault = wait_of(service, path, service.connect(100))
            faults.append(fault)
            print(
                f"  another reader of {path.split('/', 4)[-1]}: {wait / 1e3:.1f} s",
                file=sys.stderr,
            )
        peak = service.memory("VmHWM")
        if hasattr(service, "over"):
            service.over.set()
        code, taken = service.end()
        over.set()
        waits.sort()
        return (
            before,
            peak,
            waits,
            taken,
            [fault for fault in [*faults, code and f"exit code {code}"] if fault],
        )


print(
    f"{load()}\n\n| attack | memory before [MiB] | at most | others: median [ms] | p99 | end on SIGTERM [s] |\n|---|--:|--:|--:|--:|--:|"
)
for title, attack in ATTACKS.items():
    if args.only and title not in args.only:
        continue
    before, peak, waits, taken, faults = run(attack)
    print(
        f"| {title} | {before >> 20} | {peak >> 20} | {waits[100]:.1f} | {waits[198]:.1f} | {taken:.1f} | {'; '.join(faults)}",
        flush=True,
    )
    failures += faults
sys.exit(1 if failures else 0)
