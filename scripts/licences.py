"""Prints the licences of what is linked into the program, each text once with its crates.

python3 scripts/licences.py

That every licence is among those of deny.toml, cargo-deny checks.
"""

import json
import re
import subprocess
from collections import defaultdict
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
NAMES = re.compile(r"(licen[sc]e|copying|notice|copyright)([-_.].*)?", re.IGNORECASE)
# Texts that are in LICENSE-MIT and LICENSE-APACHE beside this one.
OWN = re.compile(r"\b(MIT|Apache-2\.0)\b")


def cargo(*arguments: str) -> Any:
    command = ["cargo", "metadata", "--format-version", "1", "--locked", *arguments]
    return json.loads(subprocess.run(command, check=True, cwd=ROOT, capture_output=True).stdout)


def linked() -> list[dict[str, Any]]:
    """The packages of others that the program contains: no build scripts, macros or tests."""
    host = re.search(
        r"host: (.*)",
        subprocess.run(["rustc", "-vV"], check=True, capture_output=True, text=True).stdout,
    )
    assert host
    metadata = cargo("--filter-platform", host[1])
    packages = {one["id"]: one for one in metadata["packages"]}
    nodes = {one["id"]: one for one in metadata["resolve"]["nodes"]}
    found: set[str] = set()
    ahead = [metadata["resolve"]["root"]]
    while ahead:
        here = ahead.pop()
        kinds = {kind for target in packages[here]["targets"] for kind in target["kind"]}
        if here not in found and "proc-macro" not in kinds:
            found.add(here)
            ahead += [
                one["pkg"]
                for one in nodes[here]["deps"]
                if any(kind["kind"] is None for kind in one["dep_kinds"])
            ]
    others = [packages[one] for one in found if packages[one]["source"]]
    return sorted(others, key=lambda one: (one["name"], one["version"]))


def texts(package: dict[str, Any]) -> list[str]:
    folder = Path(package["manifest_path"]).parent
    files = sorted(
        path
        for path in folder.rglob("*")
        if path.is_file() and NAMES.fullmatch(path.name) and path.suffix != ".rs"
    )
    return [
        "\n".join(
            line.rstrip() for line in path.read_text("utf-8", "replace").strip().splitlines()
        )
        for path in files
    ]


def main() -> None:
    crates = linked()
    having: dict[str, list[str]] = defaultdict(list)
    without = []
    for package in crates:
        name = f"{package['name']} {package['version']} ({package['license']})"
        found = texts(package)
        for text in dict.fromkeys(found):
            having[text].append(name)
        if not found:
            assert OWN.search(package["license"] or ""), f"{name} comes without its licence"
            without.append(f"{name}, by {', '.join(package['authors']) or 'its contributors'}")
    print(f"{len(crates)} crates are part of the program. Their licences:")
    for text, names in sorted(having.items(), key=lambda one: one[1]):
        print("\n" + "=" * 80, *names, "-" * 80, text, sep="\n")
    print(
        "\n" + "=" * 80,
        "Under the terms of LICENSE-MIT or LICENSE-APACHE, without a text of their own:",
        *without,
        sep="\n",
    )


if __name__ == "__main__":
    main()
