"""Jobs over the processes of an executor: each has a local program of one solver of its own."""

from __future__ import annotations

import contextlib
import os
import platform
import tempfile
import threading
import traceback
from collections.abc import Callable, Generator, Iterator
from concurrent.futures import BrokenExecutor, Executor, Future
from dataclasses import dataclass
from multiprocessing.util import Finalize
from pathlib import Path
from queue import SimpleQueue
from typing import Any

from ._client import Client
from ._course import Course, Outcome, Task
from ._errors import BrinellError, JobFailed, ServerDied, ServerNotFound

# Tasks that are at an executor at a time: enough for some hundred workers.
IN_FLIGHT = 256


@dataclass(frozen=True)
class Wanted:
    """Whether results are still wanted, for workers of the same machine: a file that is there."""

    path: Path
    folder: tuple[str, int, int] | None

    def __call__(self) -> bool:
        """Whether they are; where its folder is not there they always are."""
        return self.path.exists() or self.folder != known(self.path.parent)


def known(folder: Path) -> tuple[str, int, int] | None:
    """A folder as this machine knows it. A container, or a job of Slurm, on the same machine may
    have another one under its name.
    """
    with contextlib.suppress(OSError):
        found = folder.stat()
        return platform.node(), found.st_dev, found.st_ino
    return None


@contextlib.contextmanager
def wanted() -> Iterator[Wanted]:
    """Results are wanted until this is left."""
    handle, name = tempfile.mkstemp(prefix="brinell-wanted-")
    os.close(handle)
    path = Path(name)
    try:
        yield Wanted(path, known(path.parent))
    finally:
        path.unlink(missing_ok=True)


def over(
    executor: Executor, course: Course, parts: str
) -> Generator[tuple[int, Any, Outcome], None, None]:
    """Solves the jobs of a course; yields place, job and answer of each."""
    finished: SimpleQueue[Future[Outcome]] = SimpleQueue()
    tasks: dict[Future[Outcome], Task] = {}
    lost: list[Task] = []
    with wanted() as are_wanted:
        try:
            while not course.over:
                for task in [*lost, *course.take()]:
                    future = executor.submit(solve_here, task.document, parts, are_wanted)
                    tasks[future] = task
                    future.add_done_callback(finished.put)
                lost = []
                if answers := list(course.answers()):
                    yield from answers
                elif tasks:
                    future = finished.get()
                    task = tasks.pop(future)
                    outcome = _outcome(task, future)
                    if outcome is None:
                        lost.append(task)
                    else:
                        course.finish(task, outcome)
        finally:
            for future in tasks:
                future.cancel()


def _outcome(task: Task, future: Future[Outcome]) -> Outcome | None:
    """What a worker has sent; `None` if it is to be sent once more. An executor that is broken, or
    has no program, ends the run.
    """
    try:
        return future.result()
    except (BrokenExecutor, ServerNotFound):
        raise
    except Exception as reason:
        # A job that fails is an outcome. An exception is of the executor: Dask has a `TypeError`
        # for a result whose worker is killed while it is fetched.
        if not task.was_lost:
            task.was_lost = True
            return None
        detail = traceback.format_exception_only(reason)[-1].strip()
        return Outcome(task.document, "", None, JobFailed("", "failed", {"detail": detail}))


# In the processes of the executor.

_lock = threading.Lock()
_client: tuple[int, Client] | None = None


def _here() -> Client:
    """The client of this process; it ends with the process."""
    global _client
    with _lock:
        if _client is None or _client[0] != os.getpid():
            client = Client(workers=1)
            # A process of a pool ends without what `atexit` has.
            Finalize(None, client.close, exitpriority=1)
            _client = (os.getpid(), client)
        return _client[1]


def version_here() -> str:
    """The version of the program that solves in this process."""
    client = _here()
    return client._run(client._core.version())


def solve_here(document: dict[str, Any], parts: str, are_wanted: Callable[[], bool]) -> Outcome:
    """Solves a job in this process."""
    global _client
    client = _here()
    try:
        flow = client._core.solve(document, parts=parts, fields=True, is_wanted=are_wanted)
        return client._run(flow)
    except ServerNotFound:
        raise
    except BrinellError as error:
        if isinstance(error, ServerDied):
            # The next job gets another server.
            _client = None
        return Outcome(document, "", None, error)
