#!/usr/bin/env python3
"""Measures how bad receivers of announcements delay a good one.

usage: tools/receivers.py [--jobs 40] [--binary target/release/brinell]

Seven hosts (127.0.0.2 and on: Linux) misbehave: silent, answering byte by byte, without end, with
heads without end, by redirects, with noise, or not at all. The jobs for the good host are
submitted behind theirs. Prints the delays of the good announcements, the calls to each host, and
the memory of the service.
"""

import argparse, base64, os, socket, threading, time
from urllib.parse import quote

from harness import EXAMPLES, Service, load

parser = argparse.ArgumentParser()
parser.add_argument("--jobs", type=int, default=40)
parser.add_argument("--seconds", type=float, default=60)
parser.add_argument("--binary", default="target/release/brinell")
args = parser.parse_args()
calls = {}


def drip(connection):
    connection.sendall(b"HTTP/1.1 200 OK\r\nX: ")
    for _ in range(200):
        connection.sendall(b"y")
        time.sleep(0.5)


def repeat(connection, head, part):
    connection.sendall(b"HTTP/1.1 200 OK\r\n" + head)
    end = time.monotonic() + 60
    while time.monotonic() < end:
        connection.sendall(part)


BEHAVIOURS = {
    "good": lambda connection: connection.sendall(
        b"HTTP/1.1 204 No Content\r\nConnection: close\r\n\r\n"
    ),
    "silent": lambda connection: time.sleep(100),
    "drips": drip,
    "endless": lambda connection: repeat(
        connection, b"Transfer-Encoding: chunked\r\n\r\n", b"10000\r\n" + bytes(65536) + b"\r\n"
    ),
    "heads": lambda connection: repeat(connection, b"", b"A: " + b"b" * 1000 + b"\r\n"),
    "redirects": lambda connection: connection.sendall(
        b"HTTP/1.1 302 Found\r\nLocation: http://127.0.0.2/\r\nContent-Length: 0\r\n\r\n"
    ),
    "noise": lambda connection: connection.sendall(os.urandom(5000)),
    "closes": lambda connection: None,
}


def answer(name, connection):
    with connection:
        try:
            request = b""
            while b"\r\n\r\n" not in request:
                more = connection.recv(65536)
                if not more:
                    return
                request += more
            calls[name] = calls.get(name, 0) + 1
            BEHAVIOURS[name](connection)
        except OSError:
            pass  # The service has had enough.


def accept(name, listener):
    while True:
        threading.Thread(target=answer, args=(name, listener.accept()[0]), daemon=True).start()


addresses = {}
for number, name in enumerate(BEHAVIOURS, 2):
    listener = socket.create_server((f"127.0.0.{number}", 0), backlog=500)
    addresses[name] = "%s:%d" % listener.getsockname()
    threading.Thread(target=accept, args=(name, listener), daemon=True).start()

os.environ["BRINELL_WEBHOOK_SECRETS"] = "whsec_" + base64.b64encode(os.urandom(32)).decode()
hosts = [
    flag for address in addresses.values() for flag in ("--webhook-host", address.split(":")[0])
]
JOB = {**EXAMPLES["two_cylinders"], "mesh": {"elements_per_half_width": 4}}
with Service(args.binary, *hosts, "--webhook-allow-private") as service:

    def submit(name):
        address = quote(f"http://{addresses[name]}/")
        return service.ask("POST", f"/v1/jobs?callback_url={address}", JOB)[1]["id"]

    for name in [*addresses][1:]:
        for _ in range(args.jobs):
            submit(name)
    begin = time.monotonic()
    for _ in range(args.jobs):
        submit("good")
    while calls.get("good", 0) < args.jobs and time.monotonic() - begin < args.seconds:
        time.sleep(0.05)
    print(
        f"{calls.get('good', 0)} of {args.jobs} good announcements after {time.monotonic() - begin:.1f} s; {load()}",
        flush=True,
    )
    time.sleep(args.seconds)
    begin = time.monotonic()
    submit("good")
    while calls.get("good", 0) <= args.jobs and time.monotonic() - begin < args.seconds:
        time.sleep(0.01)
    print(
        f"another after {time.monotonic() - begin:.2f} s; calls {calls}; {service.memory() >> 20} MiB"
    )
