"""Shared by the scripts: a service on a free port, and PostgreSQL on a port of its own."""

import glob, http.client, json, os, re, shutil, socket, subprocess, sys, tempfile
from pathlib import Path

EXAMPLES = {
    path.stem: json.loads(path.read_text()) for path in sorted(Path("api/examples").glob("*.json"))
}


def free_port():
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        return taken.getsockname()[1]


def load():
    """Load of the machine by all processes, to judge the figures by."""
    return f"load {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores"


class Service:
    """`brinell serve` with a store of its own, until the end of a `with`."""

    def __init__(self, binary, *flags, database=None):
        self.data = tempfile.mkdtemp()
        self.store = ["--database-url", database] if database else ["--data-dir", self.data]
        command = [binary, "serve", "--listen", "127.0.0.1:0", *self.store, *flags]
        self.process = subprocess.Popen(
            command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        )
        self.host = self.process.stdout.readline().split("//")[1].strip()
        self.connection = self.connect()

    def connect(self, timeout=900):
        return http.client.HTTPConnection(self.host, timeout=timeout)

    def ask(self, method, path, body=None, connection=None, **headers):
        """Status and body of an answer; what is JSON is read."""
        connection = connection or self.connection
        text = json.dumps(body) if isinstance(body, dict) else body
        connection.request(method, path, text, {"Content-Type": "application/json", **headers})
        answer = connection.getresponse()
        text = answer.read()
        return answer.status, json.loads(text) if "json" in (
            answer.getheader("content-type") or ""
        ) else text

    def submit(self, job):
        status, receipt = self.ask("POST", "/v1/jobs", job)
        if status != 202:
            sys.exit(f"refused with {status}: {receipt}")
        return receipt["id"]

    def wait(self, name, seconds=float("inf")):
        """The job once it is done, or as it is after so long."""
        while True:
            step = min(seconds, 5)
            document = self.ask("GET", f"/v1/jobs/{name}?wait={step}", connection=None)[1]
            seconds -= step
            if document["done"] or seconds <= 0:
                return document

    def memory(self, figure="VmRSS"):
        """Bytes of memory; `VmHWM` is the most so far."""
        return (
            int(
                re.search(
                    rf"{figure}:\s+(\d+)", Path(f"/proc/{self.process.pid}/status").read_text()
                )[1]
            )
            << 10
        )

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        code = self.process.wait()
        shutil.rmtree(self.data, ignore_errors=True)
        if code:
            print("exit code", code, file=sys.stderr)


class Cluster:
    """PostgreSQL on a port of its own (needs initdb and pg_ctl), until the end of a `with`."""

    def __init__(self):
        initdb = shutil.which("initdb") or max(glob.glob("/usr/lib/postgresql/*/bin/initdb"))
        # A link to one of the programs has not the others beside it.
        self.programs = Path(initdb).resolve().parent
        self.base = tempfile.mkdtemp()
        self.folder, self.port = f"{self.base}/cluster", free_port()
        # PostgreSQL refuses to run as root.
        self.user = ["runuser", "-u", "nobody", "--"] if os.getuid() == 0 else []
        os.mkdir(self.folder)
        if self.user:
            os.chmod(self.base, 0o755)
            shutil.chown(self.folder, "nobody")
        self.run("initdb", "-D", self.folder, "-U", "brinell", "-A", "trust")
        self.start()
        self.url = f"postgres://brinell@127.0.0.1:{self.port}/postgres"

    def start(self):
        options = f"-p {self.port} -k {self.folder} -c listen_addresses=127.0.0.1"
        self.run(
            "pg_ctl", "-D", self.folder, "-w", "-l", f"{self.folder}/log", "-o", options, "start"
        )

    def is_running(self):
        command = [*self.user, str(self.programs / "pg_ctl"), "-D", self.folder, "status"]
        return subprocess.run(command, stdout=subprocess.DEVNULL, cwd="/").returncode == 0

    def run(self, program, *arguments):
        subprocess.run(
            [*self.user, str(self.programs / program), *arguments],
            check=True,
            stdout=subprocess.DEVNULL,
            cwd="/",
        )

    def restart(self):
        self.run(
            "pg_ctl",
            "-D",
            self.folder,
            "-w",
            "-m",
            "immediate",
            "-l",
            f"{self.folder}/log",
            "restart",
        )

    def cut(self):
        """Ends all connections."""
        others = "FROM pg_stat_activity WHERE pid <> pg_backend_pid()"
        self.run("psql", self.url, "-qc", f"SELECT pg_terminate_backend(pid) {others}")

    def stop(self):
        self.run("pg_ctl", "-D", self.folder, "-m", "immediate", "stop")
        shutil.rmtree(self.base, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()
