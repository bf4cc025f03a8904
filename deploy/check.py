#!/usr/bin/env python3
"""Checks the files in this folder: manifests and compose file against their schemas, names and figures against the program, the proxy with nginx.

usage: deploy/check.py [path to brinell]
Needs deploy/requirements.txt, which bring the schemas along, nginx, openssl, and systemd-analyze where there is one.
"""

import json
import re
import shutil
import socket
import ssl
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request
from contextlib import contextmanager
from pathlib import Path

import kubernetes_validate
import yaml
from compose_spec import PyCompose

FOLDER = Path(__file__).resolve().parent
BINARY = sys.argv[1] if len(sys.argv) > 1 else str(FOLDER.parent / "target/debug/brinell")


def check_kubernetes():
    version = kubernetes_validate.latest_version()
    documents = [
        document
        for path in sorted((FOLDER / "kubernetes").glob("*.yaml"))
        for document in yaml.safe_load_all(path.read_text())
    ]
    for document in documents:
        kubernetes_validate.validate(document, version, strict=True)
    pods = {
        document["metadata"]["name"]: document["spec"]["template"]["spec"]
        for document in documents
        if document["kind"] == "Deployment"
    }
    for pod in pods.values():
        for container in pod["containers"]:
            check_arguments(container["args"])
            check_variables(entry["name"] for entry in container["env"])
    print(f"{len(documents)} manifests are valid against Kubernetes {version}")


def check_compose():
    compose = yaml.safe_load((FOLDER / "compose.yaml").read_text())
    # Aliases resolved: the schema knows none.
    parsed = PyCompose.from_yaml(yaml.safe_dump(compose))
    parsed.validate()
    parsed.to_spec()
    for name, service in compose["services"].items():
        if name != "postgres":
            check_arguments(service["command"])
            check_variables(service["environment"])
    print(f"{len(compose['services'])} services of the compose file are valid")


def check_systemd():
    if not shutil.which("systemd-analyze"):
        print("systemd-analyze is not here: the unit has not been verified")
        return
    for path in sorted((FOLDER / "systemd").glob("*.service")):
        answer = subprocess.run(
            ["systemd-analyze", "verify", "--man=no", str(path)], capture_output=True, text=True
        )
        # The program need not be installed where this is checked.
        faults = [
            line
            for line in answer.stderr.splitlines()
            if "brinell" in line and "is not executable" not in line
        ]
        assert not faults, faults
        check_variables(re.findall(r"^Environment=(\w+)=", path.read_text(), re.M))
        print(f"{path.name} is valid")


def check_nginx():
    """A service behind nginx: its links, its errors, and the events of a job that waits behind another."""
    with tempfile.TemporaryDirectory() as scratch, behind_nginx(Path(scratch)) as ask:
        assert b"<title>" in ask("/press/").read()
        job = (FOLDER.parent / "api/examples/two_cylinders.json").read_bytes()
        sweep = json.loads(job) | {"load": {"forces": list(range(300, 900))}}
        ask("/press/v1/jobs", json.dumps(sweep).encode())
        submitted = json.load(ask("/press/v1/jobs", job))
        links = submitted["links"]
        assert all(link.startswith("/press/v1/") for link in links.values()), links
        assert json.load(ask(links["self"]))["status"] == "queued"
        begun = time.monotonic()
        events = ask(links["events"])
        assert events.readline() == b"event: state\n"
        first = time.monotonic() - begun
        assert first < 5, f"the first event of a job that waits came after {first:.1f} s"
        try:
            ask("/press/v1/jobs/none")
        except urllib.error.HTTPError as refused:
            problem = json.load(refused)
        assert problem["type"].startswith("/press/"), problem
        assert ask(problem["type"]).status == 200
        assert json.load(ask("/press/openapi.json"))["servers"][0]["url"] == "/press"
    print("nginx passes links, errors and events on")


@contextmanager
def behind_nginx(scratch):
    """The service and nginx on free ports, in a folder; yields a function that asks nginx."""
    behind, front = free_port(), free_port()
    text = (FOLDER / "nginx.conf").read_text()
    own = {"127.0.0.1:8080": f"127.0.0.1:{behind}", "listen 8443": f"listen 127.0.0.1:{front}"}
    for was, now in own.items():
        assert text.count(f"{was}{' ssl' if 'listen' in was else ';'}") == 1, was
        text = text.replace(f"{was} ssl", f"{now} ssl").replace(f"server {was};", f"server {now};")
    folders = [
        f"{kind}_temp_path {kind};" for kind in ("client_body", "proxy", "fastcgi", "uwsgi", "scgi")
    ]
    text = text.replace("http {", f"http {{ access_log off; {' '.join(folders)}", 1)
    (scratch / "nginx.conf").write_text(text)
    subprocess.run(
        ["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "1", "-subj", "/CN=press.example",
         "-addext", "subjectAltName=DNS:press.example", "-keyout", scratch / "key.pem", "-out", scratch / "chain.pem"],
        check=True, capture_output=True,
    )  # fmt: skip
    serve = [
        BINARY,
        "serve",
        "--listen",
        f"127.0.0.1:{behind}",
        "--data-dir",
        ":memory:",
        "--workers",
        "1",
    ]
    serve += ["--allowed-host", "press.example", "--trusted-proxy", "127.0.0.1", "--log", "warn"]
    proxy = ["nginx", "-p", scratch, "-c", scratch / "nginx.conf", "-e", scratch / "log"]
    proxy += ["-g", f"daemon off; master_process off; pid {scratch}/nginx.pid;"]
    trust = ssl.create_default_context(cafile=None)
    trust.check_hostname, trust.verify_mode = False, ssl.CERT_NONE
    address = f"https://127.0.0.1:{front}"

    def ask(path, body=None):
        headers = {"Host": "press.example", "Content-Type": "application/json"}
        request = urllib.request.Request(address + path, body, headers)
        return urllib.request.urlopen(request, context=trust, timeout=30)

    programs = [subprocess.Popen(program, stdout=subprocess.DEVNULL) for program in (serve, proxy)]
    try:
        for port in (behind, front):
            wait_for(port)
        yield ask
    finally:
        for program in programs:
            program.kill()
            program.wait()


def wait_for(port):
    for _ in range(100):
        with socket.socket() as one:
            if one.connect_ex(("127.0.0.1", port)) == 0:
                return
        time.sleep(0.1)
    raise TimeoutError(f"nobody listens on port {port}")


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


def check_arguments(arguments):
    subprocess.run([BINARY, *arguments, "--help"], check=True, capture_output=True)


def check_variables(names):
    known = "".join(
        subprocess.run(
            [BINARY, command, "--help"], check=True, capture_output=True, text=True
        ).stdout
        for command in ("serve", "worker")
    )
    for name in names:
        assert re.search(rf"\[env: {name}[=\]]", known), f"{name} is no setting"


check_kubernetes()
check_compose()
check_systemd()
check_nginx()
