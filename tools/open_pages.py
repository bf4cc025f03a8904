#!/usr/bin/env python3
"""Measures the cost of open pages: jobs a second through POST /v1/solve with and without them.

usage: tools/open_pages.py [--pages 50] [--rounds 6] [--seconds 5] [--elements 8] [--release
            target/release]

Needs wrk and `cargo build --release`. Every page sends the requests of web/: it fetches all files,
follows a waiting job of its own by server-sent events, queries its place in the queue every two
seconds, and lists the jobs every five. Opening the pages is not measured. Prints the change of the
rate, which other work on the machine disturbs, and the processor time of the server beyond the
cost of its jobs, as a share of all cores.
"""

import argparse, asyncio, json, os, re, statistics, subprocess, tempfile, threading, time
from pathlib import Path

parser = argparse.ArgumentParser()
parser.add_argument("--pages", type=int, default=50)
parser.add_argument("--rounds", type=int, default=6)
parser.add_argument("--seconds", type=int, default=5)
parser.add_argument("--elements", type=int, default=8)
parser.add_argument("--release", default="target/release")
args = parser.parse_args()

FILES = ["/"] + [
    f"/{path}" for path in Path("web").rglob("*") if path.is_file() and path.name != "index.html"
]
POST = """wrk.method = "POST"
wrk.headers["Content-Type"] = "application/json"
wrk.body = io.open("{job}"):read("*a")
"""


async def ask(address, path, method="GET", body=b"", coding="gzip"):
    """One request on a connection of its own; status and body."""
    reader, writer = await asyncio.open_connection(*address)
    head = f"{method} {path} HTTP/1.1\r\nHost: page\r\nAccept-Encoding: {coding}\r\nConnection: close\r\n"
    writer.write(
        f"{head}Content-Type: application/json\r\nContent-Length: {len(body)}\r\n\r\n".encode()
        + body
    )
    answer = await reader.read()
    writer.close()
    head, _, body = answer.partition(b"\r\n\r\n")
    return int(head.split()[1]), body


async def stream(address, path):
    """Reads events for ever."""
    reader, writer = await asyncio.open_connection(*address)
    writer.write(
        f"GET {path} HTTP/1.1\r\nHost: page\r\nAccept: text/event-stream\r\n\r\n".encode()
    )
    try:
        while await reader.read(4096):
            pass
    finally:
        writer.close()


async def every(seconds, address, path):
    while True:
        await asyncio.sleep(seconds)
        status, _ = await ask(address, path)
        assert status == 200, (path, status)


async def page(address, job):
    status, body = await ask(address, "/v1/jobs?priority=-100", "POST", job, "identity")
    assert status == 202, body
    job = json.loads(body)["links"]["self"]
    for path in FILES:
        status, _ = await ask(address, path)
        assert status == 200, (path, status)
    await asyncio.gather(
        stream(address, f"{job}/events"),
        every(2, address, job),
        every(5, address, "/v1/jobs?limit=30"),
    )


class Pages(threading.Thread):
    """Open pages, until closed."""

    def __init__(self, address, job):
        super().__init__()
        self.loop = asyncio.new_event_loop()
        self.fault = None
        self.work = self.loop.create_task(self.open(address, job))

    async def open(self, address, job):
        # The solvers are busy by now, and these jobs have the lowest priority: they wait, and the
        # pages with them.
        await asyncio.sleep(0.3)
        await asyncio.gather(*(page(address, job) for _ in range(args.pages)))

    def run(self):
        try:
            self.loop.run_until_complete(self.work)
        except asyncio.CancelledError:
            pass
        except Exception as fault:
            self.fault = fault

    def close(self):
        self.loop.call_soon_threadsafe(self.work.cancel)
        self.join()
        if self.fault:
            raise self.fault


async def cancel_queued(address):
    """The jobs that closed pages have left behind."""
    while jobs := json.loads(
        (await ask(address, "/v1/jobs?status=queued&limit=100", coding="identity"))[1]
    )["jobs"]:
        for job in jobs:
            await ask(address, job["links"]["cancel"], "POST")


def processor_time(pid):
    fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def load(pid, url, lua, seconds=args.seconds):
    """Jobs and processor time of the server, both a second."""
    before, begin = processor_time(pid), time.perf_counter()
    command = [
        "wrk",
        "-t1",
        "-c8",
        f"-d{seconds}s",
        "--timeout",
        "30s",
        "-s",
        str(lua),
        f"{url}/v1/solve",
    ]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    assert "Non-2xx" not in text and "Socket errors" not in text, text
    jobs = int(re.search(r"(\d+) requests in", text)[1])
    took = time.perf_counter() - begin
    return jobs / took, (processor_time(pid) - before) / took


with tempfile.TemporaryDirectory(dir=".") as folder:
    folder = Path(folder).resolve()
    job = json.loads(Path("api/examples/two_cylinders.json").read_text())
    job["mesh"] = {"elements_per_half_width": args.elements}
    (folder / "job.json").write_text(json.dumps(job))
    lua = folder / "post.lua"
    lua.write_text(POST.format(job=folder / "job.json"))
    command = [
        f"{args.release}/brinell",
        "serve",
        "--listen",
        "127.0.0.1:0",
        "--data-dir",
        str(folder / "data"),
    ]
    server = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    )
    try:
        url = "http://" + server.stdout.readline().split("//")[1].strip()
        host, port = url.removeprefix("http://").split(":")
        address = (host, int(port))
        load(server.pid, url, lua)
        rows = []
        for number in range(args.rounds):
            pages = Pages(address, json.dumps(job).encode())
            measured = {}
            for opened in (number % 2 == 0, number % 2 == 1):
                if opened:
                    # Opening is not measured: two seconds of the same load go before.
                    pages.start()
                    load(server.pid, url, lua, 2)
                measured[opened] = load(server.pid, url, lua)
                if opened:
                    pages.close()
                    asyncio.run(cancel_queued(address))
            (alone, cost), (opened, used) = measured[False], measured[True]
            # What the server used beyond what its jobs cost without pages.
            rows.append((alone, opened, used - opened * cost / alone))
            print(
                f"  round {number + 1}: {alone:.1f} jobs/s alone, {opened:.1f} with pages, "
                f"which took {1000 * rows[-1][2]:.0f} ms of processor time a second",
                flush=True,
            )
        change = 100 * (statistics.median(opened / alone for alone, opened, _ in rows) - 1)
        taken = statistics.median(row[2] for row in rows)
        print(
            f"{args.pages} open pages: {change:+.1f} % jobs a second by the clock; {1000 * taken:.0f} ms of processor time a "
            f"second, {100 * taken / os.cpu_count():.1f} % of {os.cpu_count()} cores (medians of {args.rounds} rounds)"
        )
    finally:
        server.terminate()
        server.wait()
