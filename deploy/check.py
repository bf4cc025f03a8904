#!/usr/bin/env python3
"""Checks the files in this folder: manifests and compose file against their schemas, names and figures against the program.

usage: deploy/check.py [path to brinell]
Needs deploy/requirements.txt, which bring the schemas along, and systemd-analyze where there is one.
"""

import re
import shutil
import subprocess
import sys
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
