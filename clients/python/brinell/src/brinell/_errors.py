"""The exceptions of this package."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any


class BrinellError(Exception):
    """Base class of all exceptions of this package."""

    def __reduce__(self) -> tuple[Any, ...]:
        # The arguments of the classes below are not those of `Exception`.
        return _copied, (type(self), self.args), vars(self)


def _copied(kind: type[BrinellError], args: tuple[Any, ...]) -> BrinellError:
    return kind.__new__(kind, *args)


@dataclass(frozen=True)
class Fault:
    """One fault of a job."""

    pointer: str
    """JSON pointer of the field, as in `#/upper/shape/radius`; `#` is the whole job."""
    code: str
    """The kind of fault, for programs."""
    detail: str
    """What is wrong and what would be right."""

    def __str__(self) -> str:
        return f"{self.pointer}: {self.detail}"


class InvalidJob(BrinellError, ValueError):
    """The job is invalid. `errors` has all its faults."""

    def __init__(self, errors: Sequence[Fault], detail: str = "") -> None:
        self.errors = tuple(errors)
        lines = [f"  {fault}" for fault in self.errors]
        super().__init__("\n".join([detail or "the job is not valid", *lines]))


class ServiceError(BrinellError):
    """The service answered with an error."""

    def __init__(
        self, status: int, problem: dict[str, Any], retry_after: float | None = None
    ) -> None:
        self.status = status
        """The HTTP status."""
        self.problem = problem
        """The service's own words (RFC 9457)."""
        self.retry_after = retry_after
        """Seconds after which it may be tried again, if the service says so."""
        title = problem.get("title") or f"HTTP status {status}"
        detail = problem.get("detail")
        super().__init__(f"{title}: {detail}" if detail else str(title))

    @property
    def kind(self) -> str:
        """The last word of the problem's type, as in `queue-full`."""
        return str(self.problem.get("type", "")).rsplit("/", 1)[-1]


class Unauthorized(ServiceError):
    """The API key is missing, invalid, or may not do this."""


class NotFound(ServiceError):
    """There is no such job, or it belongs to another API key."""


class QuotaExceeded(ServiceError):
    """The queue is full, or a quota of the API key is used up."""


class Unavailable(ServiceError):
    """The service does not answer, or is unavailable."""


class ServerDied(Unavailable):
    """The local server has ended. `log` is the file with its log."""

    def __init__(self, exit_code: int | None, log: Path, last: str = "") -> None:
        self.exit_code = exit_code
        self.log = log
        said = f"; its last words: {last}" if last else ""
        super().__init__(
            0,
            {"title": f"the local server ended, exit code {exit_code}; its log is {log}{said}"},
        )


class ServerNotFound(BrinellError):
    """There is no `brinell` program on this machine and no service was named."""


class JobFailed(BrinellError):
    """The job has ended without a result."""

    def __init__(self, id: str, status: str, problem: dict[str, Any] | None) -> None:
        self.id = id
        self.status = status
        self.problem = problem or {}
        detail = self.problem.get("detail") or self.problem.get("title")
        super().__init__(
            f"job {id} {status.replace('_', ' ')}" + (f": {detail}" if detail else "")
        )


class StillRunning(BrinellError, TimeoutError):
    """The job is not done within the given time; it continues."""


def faults_of(problem: dict[str, Any]) -> list[Fault]:
    """The faults that a problem lists."""
    errors = problem.get("errors") or []
    return [
        Fault(e.get("pointer") or f"?{e.get('parameter', '')}", e["code"], e["detail"])
        for e in errors
    ]


_SMALLER = (
    "brinell.Client(max_body=...) sets it for a local server, and brinell.surface(..., size=512) "
    "thins a surface to 512 heights along a side"
)


def error_of(
    status: int, problem: dict[str, Any], retry_after: float | None = None
) -> BrinellError:
    """The exception for an answer."""
    kind = str(problem.get("type", "")).rsplit("/", 1)[-1]
    if status == 413:
        detail = str(problem.get("detail") or problem.get("title"))
        problem = {**problem, "detail": f"{detail}; {_SMALLER}"}
    if kind == "invalid-job" or (status == 422 and problem.get("errors")):
        return InvalidJob(faults_of(problem), str(problem.get("title", "")))
    if status == 422:
        return InvalidJob([Fault("#", kind, str(problem.get("detail") or problem.get("title")))])
    if status in (401, 403):
        return Unauthorized(status, problem)
    if status == 404:
        return NotFound(status, problem)
    if status == 429:
        return QuotaExceeded(status, problem, retry_after)
    if status in (408, 502, 503, 504, 507):
        return Unavailable(status, problem, retry_after)
    return ServiceError(status, problem, retry_after)
