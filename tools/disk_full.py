#!/usr/bin/env python3
"""Fills the disk under `brinell serve`, frees it, and shows what the service answers meanwhile.

usage: tools/disk_full.py [--binary target/release/brinell] [--size 12m]
Mounts a tmpfs in namespaces of its own (`unshare --user --mount`); needs no rights. Each part ends with a line that
says what was seen, and with exit code 1 if it is not what docs/operations.md promises.

1. A reserve of 0: jobs with fields fill the disk to the last byte. Space is freed by another
   file's removal; submit, claim and cancel work again within seconds.
2. A reserve: jobs are refused with 507 before the disk is full, and what was accepted finishes.
3. `ulimit -f`: a file reaches the largest size the process may write; the process lives.
4. The disk under the tables of PostgreSQL is filled to the last byte and freed.
5. The disk under all of PostgreSQL is filled, at which PostgreSQL may end, and freed; then
   PostgreSQL is started again.
"""

import argparse, http.client, json, os, resource, shutil, subprocess, sys, tempfile, time
from pathlib import Path

from harness import Cluster

parser = argparse.ArgumentParser()
parser.add_argument("--binary", default="target/release/brinell")
parser.add_argument("--size", default="12m")
parser.add_argument("--elements", type=int, default=16)
parser.add_argument("--inside", action="store_true", help=argparse.SUPPRESS)
args = parser.parse_args()

if not args.inside:
    # PostgreSQL refuses to run as root, and only root may be somebody else.
    own = (
        ["unshare", "--mount"]
        if os.getuid() == 0
        else ["unshare", "--user", "--map-current-user", "--keep-caps", "--mount"]
    )
    sys.exit(
        subprocess.run([*own, sys.executable, __file__, *sys.argv[1:], "--inside"]).returncode
    )

JOB = json.loads(Path("api/examples/two_cylinders.json").read_text())
JOB["mesh"] = {"elements_per_half_width": args.elements}
JOB["output"] = {"fields": True}
failures = []


def check(seen, what):
    print(f"{'ok  ' if seen else 'FAIL'} {what}", flush=True)
    if not seen:
        failures.append(what)


class Service:
    def __init__(self, directory, *flags, limit=None, database=None):
        store = ["--database-url", database] if database else ["--data-dir", f"{directory}/data"]
        command = [args.binary, "serve", "--listen", "127.0.0.1:0", *store, *flags]
        set_limit = (
            (lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))) if limit else None
        )
        self.log = tempfile.TemporaryFile("w+")
        self.process = subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=self.log, text=True, preexec_fn=set_limit
        )
        self.host = self.process.stdout.readline().split("//")[1].strip()

    def ask(self, method, path, body=None):
        connection = http.client.HTTPConnection(self.host, timeout=60)
        connection.request(
            method, path, body and json.dumps(body), {"Content-Type": "application/json"}
        )
        answer = connection.getresponse()
        text = answer.read()
        kind = answer.getheader("content-type") or ""
        return answer.status, json.loads(text) if "json" in kind else text

    def fill(self, most=500):
        """Submits until a job is refused; the statuses seen, and the accepted jobs."""
        accepted = []
        for _ in range(most):
            status, body = self.ask("POST", "/v1/jobs", JOB)
            if status != 202:
                return status, body, accepted
            accepted.append(body["id"])
            self.ask("GET", f"/v1/jobs/{accepted[-1]}?wait=5")
        return 202, None, accepted

    def until(self, method, path, body, wanted, seconds=20):
        """Seconds until the answer is as wanted; None if it never is."""
        begin = time.monotonic()
        while time.monotonic() - begin < seconds:
            if self.ask(method, path, body)[0] in wanted:
                return time.monotonic() - begin
            time.sleep(0.1)
        return None

    def end(self):
        self.process.terminate()
        code = self.process.wait(60)
        self.log.seek(0)
        return code, self.log.read()


def mounted(size):
    directory = tempfile.mkdtemp()
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", directory], check=True)
    return directory


def to_the_last_byte():
    print("1. to the last byte")
    directory = mounted(args.size)
    ballast = Path(directory, "ballast")
    ballast.write_bytes(bytes(4 << 20))
    service = Service(directory, "--min-free-disk", "0")
    status, body, accepted = service.fill()
    check(
        status == 507 and body["type"] == "/problems/insufficient-storage",
        f"refused with {status} {body and body['type']}",
    )
    status, body = service.ask("GET", "/readyz")
    check(
        status == 507 and "disk is full" in body["detail"],
        f"/readyz answers {status}: {body.get('detail')}",
    )
    check(service.ask("GET", "/livez")[0] == 200, "/livez answers 200")
    ballast.unlink()
    seconds = service.until("GET", "/readyz", None, (200,))
    check(seconds is not None, f"/readyz is 200 again after {seconds} s")
    small = {**JOB, "output": {}}
    status, receipt = service.ask("POST", "/v1/jobs", small)
    check(status == 202, f"a job is accepted again: {status}")
    if status == 202:
        seconds = service.until("GET", f"/v1/jobs/{receipt['id']}/result", None, (200,))
        check(seconds is not None, f"it is claimed and solved after {seconds} s")
        check(
            service.ask("POST", f"/v1/jobs/{accepted[-1]}/cancel")[0] == 200, "cancel answers 200"
        )
    lost = [
        job
        for job in accepted[:-1]
        if service.ask("GET", f"/v1/jobs/{job}")[1]["status"] == "failed"
    ]
    check(not lost, f"none of {len(accepted)} accepted jobs failed")
    code, log = service.end()
    check(
        code == 0 and "disk is full" in log,
        f"exit code {code}, the log says that the disk is full",
    )


def with_a_reserve():
    print("2. with a reserve of 4 MiB")
    directory = mounted(args.size)
    service = Service(directory, "--min-free-disk", "4")
    status, body, accepted = service.fill()
    free = os.statvfs(directory)
    check(
        status == 507,
        f"refused with {status} while {free.f_bavail * free.f_frsize >> 10} KiB are free",
    )
    states = {service.ask("GET", f"/v1/jobs/{job}?wait=30")[1]["status"] for job in accepted}
    check(states == {"succeeded"}, f"{len(accepted)} accepted jobs: {states}")
    for job in accepted[: len(accepted) // 2]:
        service.ask("DELETE", f"/v1/jobs/{job}")
    seconds = service.until("POST", "/v1/jobs", {**JOB, "output": {}}, (202,))
    check(seconds is not None, f"half of them removed, a job is accepted after {seconds} s")
    service.end()


def file_size_limit():
    print("3. a limit on the size of files")
    directory = tempfile.mkdtemp()
    service = Service(directory, "--min-free-disk", "0", limit=6 << 20)
    status, body, accepted = service.fill()
    check(status in (503, 507), f"refused with {status} {body and body['type']}")
    check(
        service.process.poll() is None and service.ask("GET", "/livez")[0] == 200,
        "the process lives",
    )
    check(service.end()[0] == 0, "and exits with 0")


def under_postgres(holds_log):
    """PostgreSQL, its log on the full disk, may end; it is started again once there is space."""
    print(
        f"{5 if holds_log else 4}. under PostgreSQL, {'all of it' if holds_log else 'its tables'}"
    )
    directory = mounted("120m")
    os.chmod(directory, 0o755)
    tempfile.tempdir = directory if holds_log else None
    with Cluster() as cluster:
        if not holds_log:
            shutil.chown(directory, *["nobody"] if cluster.user else [os.getuid()])
            for statement in (
                f"CREATE TABLESPACE small LOCATION '{directory}'",
                "ALTER DATABASE postgres SET default_tablespace = small",
            ):
                subprocess.run(["psql", cluster.url, "-qc", statement], check=True)
        service = Service(directory, database=cluster.url)
        free = os.statvfs(directory)
        ballast = Path(directory, "ballast")
        ballast.write_bytes(
            bytes(free.f_bavail * free.f_frsize - (12 << 20 if holds_log else 6 << 20))
        )
        status, body, accepted = service.fill()
        wanted = (503, 507) if holds_log else (507,)
        check(
            status in wanted,
            f"refused with {status} {body and body['type']} after {len(accepted)} jobs",
        )
        status, body = service.ask("GET", "/readyz")
        # PostgreSQL may still have room for one row in the pages that it has.
        check(status in (200, *wanted), f"/readyz answers {status}: {body.get('detail')}")
        check(service.ask("GET", "/livez")[0] == 200, "/livez answers 200")
        ballast.unlink()
        if not cluster.is_running():
            print("     PostgreSQL has ended and is started again")
            cluster.start()
        seconds = service.until("GET", "/readyz", None, (200,))
        check(seconds is not None, f"/readyz is 200 again after {seconds} s")
        status, receipt = service.ask("POST", "/v1/jobs", {**JOB, "output": {}})
        check(status == 202, f"a job is accepted again: {status}")
        if status == 202:
            seconds = service.until("GET", f"/v1/jobs/{receipt['id']}/result", None, (200,), 90)
            check(seconds is not None, f"it is claimed and solved after {seconds} s")
        states = {
            service.ask("GET", f"/v1/jobs/{job}?wait=90")[1].get("status") for job in accepted
        }
        check(states == {"succeeded"}, f"{len(accepted)} accepted jobs: {states}")
        code, log = service.end()
        check(
            code == 0 and (holds_log or "disk is full" in log),
            f"exit code {code}; the log says {'disk is full' if 'disk is full' in log else 'storage is unavailable'}",
        )


to_the_last_byte()
with_a_reserve()
file_size_limit()
under_postgres(holds_log=False)
under_postgres(holds_log=True)
sys.exit(1 if failures else 0)
