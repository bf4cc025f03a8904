"""A local server that ends with this process, also after a crash."""

from __future__ import annotations

import contextlib
import os
import secrets
import shutil
import subprocess
import sys
import tempfile
import weakref
from pathlib import Path

from ._errors import BrinellError, ServerDied, ServerNotFound

# Bounds of the store in memory [MiB]: what it may take, and what results may before the oldest
# are removed.
KEEP_MEMORY, KEEP_STORED = 1024, 512
# Largest request [bytes]: two surfaces of 1024 × 1024 heights as float64, or a batch of smaller.
MAX_BODY = 64 << 20
# Grace time for running jobs [s]: no client is left to fetch their results.
GRACE = 0.1
# Time after which a server that does not end by itself is killed [s].
PATIENCE = 5.0


def find_program(program: str | os.PathLike[str] | None = None) -> str:
    """The `brinell` program: the one named, that of the package `brinell-server`, or the first on
    PATH.
    """
    named = program or os.environ.get("BRINELL_PROGRAM")
    if named:
        return os.fspath(named)
    try:
        from brinell_server import find_brinell
    except ImportError:
        found = shutil.which("brinell")
    else:
        found = find_brinell()
    if found is None:
        raise ServerNotFound(
            "there is no brinell program on the PATH: add its folder, name it by BRINELL_PROGRAM, "
            "or name a service by brinell.Client(url=...) or BRINELL_URL"
        )
    return found


class LocalServer:
    """`brinell serve` on a free loopback port, with a key of its own."""

    def __init__(
        self,
        program: str | os.PathLike[str] | None = None,
        workers: int | None = None,
        max_body: int | None = None,
    ) -> None:
        program = find_program(program)
        self.key = secrets.token_hex(32)
        handle, name = tempfile.mkstemp(prefix="brinell-", suffix=".log")
        self.log = Path(name)
        # Settings of another service do not apply.
        environment = {k: v for k, v in os.environ.items() if not k.startswith("BRINELL_")}
        environment["BRINELL_ONCE_KEY"] = self.key
        arguments = [
            *("serve", "--listen", "127.0.0.1:0", "--data-dir", ":memory:", "--log", "info"),
            *("--once-key-env", "BRINELL_ONCE_KEY", "--exit-with-stdin", "--grace", str(GRACE)),
            *("--keep-memory", str(KEEP_MEMORY), "--keep-stored", str(KEEP_STORED)),
            *("--max-body", str(max_body or MAX_BODY)),
            *(("--workers", str(workers)) if workers else ()),
        ]
        with os.fdopen(handle, "wb") as log:
            # A session of its own: Ctrl-C must reach only the caller, which cancels the job.
            self._process = subprocess.Popen(
                [program, *arguments],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=log,
                env=environment,
                start_new_session=sys.platform != "win32",
            )
        self._end = weakref.finalize(self, _end, self._process, self.log)
        _servers.add(self)
        assert self._process.stdout is not None
        line = self._process.stdout.readline().decode(errors="replace").strip()
        self.url = line.removeprefix("brinell listening on ")
        if not self.url.startswith("http"):
            self._process.wait(PATIENCE)
            raise self._died()

    @property
    def pid(self) -> int:
        """The server's process."""
        return self._process.pid

    def check(self) -> None:
        """Raises `ServerDied` if the server has ended by itself."""
        if not self._end.alive:
            raise BrinellError("this client is closed, and its local server with it")
        # The kernel refuses connections a moment before a process that dies can be waited for.
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(GRACE)
        if self._process.poll() is not None:
            raise self._died()

    def _died(self) -> ServerDied:
        self._end.detach()
        text = self.log.read_text("utf-8", errors="replace").strip()
        return ServerDied(self._process.returncode, self.log, text.rsplit("\n", 1)[-1])

    def _let_go(self) -> None:
        """In a forked process: the server is not its own, and has to end with its parent."""
        self._end.detach()
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe is not None:
                pipe.close()

    def close(self) -> None:
        """Ends the server."""
        self._end()


def _end(process: subprocess.Popen[bytes], log: Path) -> None:
    for pipe in (process.stdin, process.stdout):
        if pipe is not None:
            pipe.close()
    try:
        process.wait(PATIENCE)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
    log.unlink(missing_ok=True)


_servers: weakref.WeakSet[LocalServer] = weakref.WeakSet()
"""The servers of this process and of those that it was forked from."""


def _let_go() -> None:
    for server in list(_servers):
        server._let_go()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_let_go)
