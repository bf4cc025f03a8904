"""The files of a study: a result each, under a name that every run and every program finds.

A name is the digest of the job and the version of the program, `<digest>-<version>.jsonl`. The
first line is the result without its large parts, the second the job, the third the whole result;
the fields of its first step are `<digest>-<version>.1.npz`. `brinell solve --array` writes the
same.
"""

from __future__ import annotations

import copy
import hashlib
import json
import math
import os
import re
import struct
import uuid
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, TypeAlias

from ._course import Outcome
from ._errors import BrinellError
from ._plain import need

Address: TypeAlias = str | os.PathLike[str]
"""A folder, or an address of fsspec."""

SUFFIX = ".jsonl"
RESULT = re.compile(r"[0-9a-f]{32}-.+\.jsonl")


def digest_of(document: Any) -> str:
    """The digest of a job: 128 bits of SHA-256 of its values.

    A number counts by the bits of its double, an object by its members in the order of their
    names: neither spaces nor `20` for `20.0` make another job.
    """
    return hashlib.sha256(b"".join(_pieces(document))).hexdigest()[:32]


def _pieces(value: Any) -> Iterator[bytes]:
    if value is None or isinstance(value, bool):
        yield {None: b"n", True: b"t", False: b"f"}[value]
    elif isinstance(value, (int, float)):
        yield b"d" + struct.pack(">d", _double(value))
    elif isinstance(value, str):
        text = value.encode(errors="surrogatepass")
        yield b"s%d:" % len(text) + text
    elif isinstance(value, dict):
        yield b"{"
        for name in sorted(value, key=str.encode):
            yield from _pieces(name)
            yield from _pieces(value[name])
        yield b"}"
    else:
        yield b"["
        for one in value:
            yield from _pieces(one)
        yield b"]"


def _double(value: float) -> float:
    try:
        return float(value)
    except OverflowError:
        return math.inf


class Files:
    """A folder of this machine, or one behind fsspec."""

    def __init__(self, address: Address, make: bool) -> None:
        self._fs: Any = None
        self.address = os.fspath(address)
        if "://" in self.address:
            self._fs, self.address = need("fsspec.core", "studies").url_to_fs(self.address)
            if "file" in self._fs.protocol:
                self._fs = None
        if make and self._fs is None:
            Path(self.address).mkdir(parents=True, exist_ok=True)
        elif make:
            self._fs.makedirs(self.address, exist_ok=True)

    def results(self) -> list[str]:
        """The names of the files that are results."""
        if self._fs is None:
            names = os.listdir(self.address)
        else:
            names = [path.rsplit("/", 1)[-1] for path in self._fs.ls(self.address, detail=False)]
        return [name for name in names if RESULT.fullmatch(name)]

    def lines(self, name: str, count: int) -> list[Any]:
        """The first lines of a result: without its large parts, the job, the whole."""
        path = f"{self.address}/{name}"
        with open(path, "rb") if self._fs is None else self._fs.open(path, "rb") as file:
            texts = [file.readline() for _ in range(count)]
        try:
            return [json.loads(text) for text in texts]
        except ValueError:
            raise BrinellError(
                f"{path} is not a whole result; it is solved again where its job is"
            ) from None

    def read(self, name: str) -> bytes:
        """A whole file."""
        path = f"{self.address}/{name}"
        data: bytes = Path(path).read_bytes() if self._fs is None else self._fs.cat_file(path)
        return data

    def write(self, name: str, data: bytes) -> None:
        """Writes a file, whole or not at all; the last of several writers wins."""
        path = f"{self.address}/{name}"
        if self._fs is not None:
            # What stores objects writes them whole.
            self._fs.pipe_file(path, data)
            return
        part = Path(f"{path}.{uuid.uuid4().hex}.part")
        try:
            part.write_bytes(data)
            part.replace(path)
        except BaseException as reason:
            # A disk that is full has no room for halves, and its error names no file.
            part.unlink(missing_ok=True)
            if isinstance(reason, OSError):
                reason.filename = path
            raise


class Archives(Sequence[bytes]):
    """The fields of a result, read when they are asked for."""

    def __init__(self, files: Files, name: str, steps: int) -> None:
        self._files, self._name, self._steps = files, name, steps

    def __len__(self) -> int:
        return self._steps

    def __getitem__(self, step: Any) -> Any:
        return self._files.read(f"{self._name}.{step + 1}.npz")


class Records:
    """The results of one version of the program in a study."""

    def __init__(self, address: Address, version: str) -> None:
        self.files, self.version = Files(address, make=True), version
        self._names = set(self.files.results())

    def _name(self, document: dict[str, Any]) -> str:
        return f"{digest_of(document)}-{self.version}"

    def get(self, document: dict[str, Any]) -> Outcome | None:
        """The result of this job, if it was there at the beginning or came since."""
        name = self._name(document) + SUFFIX
        if name not in self._names:
            return None
        try:
            return read(self.files, name)
        except (BrinellError, FileNotFoundError):
            # A machine without power may leave half a file; another hand may remove one.
            return None

    def put(self, outcome: Outcome) -> None:
        """Keeps a result; its fields first, so that a result that is there has them."""
        assert outcome.report is not None
        name = self._name(outcome.document)
        for step, archive in enumerate(outcome.fields, 1):
            self.files.write(f"{name}.{step}.npz", archive)
        lines = (summary_of(outcome.report), outcome.document, outcome.report)
        text = "".join(json.dumps(line, separators=(",", ":")) + "\n" for line in lines)
        self.files.write(name + SUFFIX, text.encode())
        self._names.add(name + SUFFIX)


def read(files: Files, name: str) -> Outcome:
    """A result that is kept."""
    _, document, report = files.lines(name, 3)
    has_fields = bool((document.get("output") or {}).get("fields"))
    steps = len(report["steps"]) if has_fields else 0
    archives = Archives(files, name.removesuffix(SUFFIX), steps)
    return Outcome(document, "", report, None, archives)


def summary_of(report: dict[str, Any]) -> dict[str, Any]:
    """A result without its large parts, as the service's `?fields=summary`."""
    made = copy.copy(report)
    made["steps"] = [_summary_of_step(step) for step in report["steps"]]
    return made


def _summary_of_step(step: dict[str, Any]) -> dict[str, Any]:
    contact = step["contact"]
    large = ("subsurface", "subsurface_below_peak", "fields", "layers")
    made = {name: value for name, value in step.items() if name not in large}
    made["contact"] = {**contact, "nodes": {name: [] for name in contact["nodes"]}}
    made["contact"].pop("maps", None)
    made["history"] = []
    zones = (step.get("plasticity") or {}).items()
    made["plasticity"] = {body: zone and {**zone, "outline": []} for body, zone in zones}
    return made
