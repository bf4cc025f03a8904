"""The operations of a client, shared by the blocking and the asynchronous one.

A flow is a generator. It yields actions (`Send`, `Sleep`, `Open`, `NextLine`, `Emit`)
and receives the answer or the exception. A client performs flows: one by blocking, the other by
awaiting.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import random
import uuid
from collections.abc import Generator, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeAlias, TypeVar

import httpx
from pydantic import BaseModel

from ._errors import (
    BrinellError,
    InvalidJob,
    JobFailed,
    QuotaExceeded,
    ServiceError,
    StillRunning,
    Unavailable,
    error_of,
)
from ._plain import JobLike, document_of

T = TypeVar("T")

# The parts of a result, all but the fields, which come as arrays by another way.
PARTS = "contact,subsurface,plasticity,history"
# The smallest of the parts, for those who want figures alone.
FIGURES = "history"
# Longest wait in one request, as the service grants it, and the shorter one of `map`, which has
# other jobs to look after.
LONGEST_WAIT = 60.0
LOOK = 1.0
# Most jobs in one request, as the service has it.
BATCH = 100
# First pause before a retry and the longest [s].
PAUSE, LONGEST_PAUSE = 0.2, 8.0


@dataclass(frozen=True)
class Send:
    """A request; its answer is the response, read to its end."""

    method: str
    path: str
    params: Mapping[str, str] = field(default_factory=dict)
    body: bytes | None = None
    headers: Mapping[str, str] = field(default_factory=dict)
    wait: float = 0.0
    """Time that the service may take beyond the client's own timeout."""


@dataclass(frozen=True)
class Open:
    """A request whose answer is read line by line. A flow has one of these open at a time."""

    request: Send


@dataclass(frozen=True)
class NextLine:
    """The next line of what is open; `None` behind the last."""


@dataclass(frozen=True)
class Sleep:
    """A pause."""

    seconds: float


@dataclass(frozen=True)
class Emit:
    """A value for the caller, who then asks for the next one."""

    value: Any


class Abandoned(BaseException):
    """Thrown into a flow behind `Emit` when the caller wants no further values."""


Effect: TypeAlias = Send | Open | NextLine | Sleep | Emit
Flow: TypeAlias = Generator[Effect, Any, T]

# Ctrl-C, or the end of an asynchronous task: the job is cancelled.
STOPPED = (KeyboardInterrupt, asyncio.CancelledError, Abandoned)


@dataclass(frozen=True)
class Event:
    """An event of a job: `state` has the job, `iteration` one iteration of its solution."""

    kind: str
    data: dict[str, Any]
    id: str


def retry_after(response: httpx.Response) -> float | None:
    """The seconds of `Retry-After`; `None` without the header."""
    try:
        return float(response.headers.get("retry-after", ""))
    except ValueError:
        return None


def failure(response: httpx.Response) -> BrinellError:
    """Returns the exception for an answer."""
    try:
        problem = response.json()
    except ValueError:
        problem = {"detail": response.text[:200]}
    return error_of(
        response.status_code, problem if isinstance(problem, dict) else {}, retry_after(response)
    )


def call(
    retries: int,
    method: str,
    path: str,
    params: Mapping[str, str] | None = None,
    body: Any = None,
    wait: float = 0.0,
    headers: Mapping[str, str] | None = None,
) -> Flow[httpx.Response]:
    """Sends a request; repeats it after temporary errors.

    A repeated POST has the same Idempotency-Key, so the service acts on it once.
    """
    sent = dict(headers or {})
    if method == "POST":
        sent.setdefault("Idempotency-Key", str(uuid.uuid4()))
    data = None
    if body is not None:
        sent["Content-Type"] = "application/json"
        data = json.dumps(body, allow_nan=False).encode()
    request = Send(method, path, params or {}, data, sent, wait)
    attempt = 0
    while True:
        error: BrinellError
        after = None
        try:
            response: httpx.Response = yield request
            if response.status_code < 400:
                return response
            error = failure(response)
            after = retry_after(response)
            if response.status_code not in (408, 429) and response.status_code < 500:
                raise error
        except httpx.TransportError as reason:
            error = unreachable(reason)
        if attempt >= retries:
            raise error
        yield Sleep(pause(attempt, after))
        attempt += 1


def unreachable(reason: httpx.TransportError) -> Unavailable:
    """The exception for a connection that fails."""
    detail = str(reason) or type(reason).__name__
    return Unavailable(0, {"title": "the service does not answer", "detail": detail})


def pause(attempt: int, after: float | None = None) -> float:
    """The time before the next attempt: what the service says or twice the last, and up to as much
    again by chance.
    """
    least = after if after is not None else min(LONGEST_PAUSE, PAUSE * 2.0**attempt)
    return least * (1.0 + random.random())


@dataclass(frozen=True)
class Outcome:
    """The end of a job: its result or its error."""

    document: dict[str, Any]
    id: str
    report: dict[str, Any] | None
    error: BrinellError | None


class Core:
    """The operations on a service."""

    def __init__(self, retries: int) -> None:
        self.retries = retries

    def json(self, method: str, path: str, **options: Any) -> Flow[Any]:
        response = yield from call(self.retries, method, path, **options)
        return response.json()

    def validate(self, job: JobLike) -> Flow[dict[str, Any]]:
        answer: dict[str, Any] = yield from self.json(
            "POST", "/v1/validate", body=document_of(job)
        )
        return answer

    def hardening_curve(self, test: dict[str, Any]) -> Flow[dict[str, Any]]:
        answer: dict[str, Any] = yield from self.json("POST", "/v1/hardening-curves", body=test)
        return answer

    def submit(
        self, document: dict[str, Any], priority: int, key: str | None = None
    ) -> Flow[dict[str, Any]]:
        """Hands a job in; with a key that came before, finds the job that came with it."""
        params = {"priority": str(priority)} if priority else {}
        headers = {"Idempotency-Key": key} if key else {}
        answer: dict[str, Any] = yield from self.json(
            "POST", "/v1/jobs", params=params, body=document, headers=headers
        )
        return answer

    def look(self, id: str) -> Flow[dict[str, Any]]:
        """Returns the present state of the job."""
        answer: dict[str, Any] = yield from self.json("GET", f"/v1/jobs/{id}")
        return answer

    def cancel(self, id: str) -> Flow[dict[str, Any]]:
        answer: dict[str, Any] = yield from self.json("POST", f"/v1/jobs/{id}/cancel")
        return answer

    def wait(self, id: str, seconds: float | None) -> Flow[dict[str, Any]]:
        """Returns the job when it is done or the time is over."""
        left = seconds
        while True:
            patience = LONGEST_WAIT if left is None else min(LONGEST_WAIT, left)
            # The answer to GET has the whole result inside; HEAD waits as long and sends nothing.
            yield from call(
                self.retries,
                "HEAD",
                f"/v1/jobs/{id}",
                params={"wait": f"{patience:g}"},
                wait=patience,
            )
            info = yield from self.look(id)
            left = None if left is None else left - patience
            if info["done"] or (left is not None and left <= 0.0):
                return info

    def report(self, id: str, seconds: float | None = None) -> Flow[dict[str, Any]]:
        """The result of a job, waited for. The fields are left out."""
        info = yield from self.wait(id, seconds)
        if not info["done"]:
            raise StillRunning(f"job {id} is {info['status']}")
        if not info["has_result"]:
            raise failed(info)
        answer: dict[str, Any] = yield from self.json(
            "GET", f"/v1/jobs/{id}/result", params={"fields": PARTS}
        )
        return answer

    def fields(self, id: str, step: int) -> Flow[bytes]:
        response = yield from call(self.retries, "GET", f"/v1/jobs/{id}/fields/{step}")
        return response.content

    def solve(self, document: dict[str, Any], events: bool) -> Flow[tuple[str, dict[str, Any]]]:
        """Submits a job and waits for its result.

        If the caller is interrupted, the job is cancelled. Emits the events on request.
        """
        key = str(uuid.uuid4())
        id = ""
        try:
            id = str((yield from self.submit(document, 0, key))["id"])
            if events:
                yield from self.events(id)
            report = yield from self.report(id)
        except STOPPED:
            with contextlib.suppress(httpx.TransportError, BrinellError):
                # The service may have accepted the job although the answer was lost.
                id = id or str((yield from self.submit(document, 0, key))["id"])
                yield from call(0, "POST", f"/v1/jobs/{id}/cancel")
            raise
        return id, report

    def events(self, id: str) -> Flow[None]:
        """Emits the events of a job, from its beginning to its end, over as many connections as it
        takes.
        """
        last = ""
        attempt = 0
        while True:
            headers = {"Accept": "text/event-stream", **({"Last-Event-ID": last} if last else {})}
            try:
                response: httpx.Response = yield Open(
                    Send("GET", f"/v1/jobs/{id}/events", headers=headers)
                )
                if response.status_code == 204:
                    return
                if response.status_code >= 400:
                    raise failure(response)
                lines: list[str] = []
                while (line := (yield NextLine())) is not None:
                    if line:
                        lines.append(line)
                        continue
                    event = event_of(lines)
                    lines = []
                    if event is None:
                        continue
                    last, attempt = event.id or last, 0
                    yield Emit(event)
                    if event.kind == "state" and event.data.get("done"):
                        return
            except httpx.TransportError as reason:
                if attempt >= self.retries:
                    raise unreachable(reason) from reason
            except ServiceError as error:
                if attempt >= self.retries or not isinstance(error, (Unavailable, QuotaExceeded)):
                    raise
            yield Sleep(pause(attempt))
            attempt += 1

    def map(
        self,
        jobs: Iterable[JobLike | InvalidJob],
        ordered: bool,
        in_flight: int,
        parts: str,
        priority: int = 0,
    ) -> Flow[None]:
        """Emits the job as given and its `Outcome`, for each job.

        At most `in_flight` are at the service. An invalid job is emitted with its fault
        as its error.
        """
        if isinstance(jobs, (str, os.PathLike, Mapping, BaseModel)):
            raise TypeError("map takes several jobs, as in [job], not one")
        if in_flight < 1:
            raise ValueError(f"in_flight is 1 at least, not {in_flight}")
        given: Iterator[tuple[int, JobLike | InvalidJob]] = iter(enumerate(jobs))
        waiting: dict[int, tuple[JobLike | InvalidJob, dict[str, Any], str]] = {}
        flying: dict[str, int] = {}
        done: dict[int, Outcome] = {}
        emitted = attempt = 0
        exhausted = False
        try:
            while True:
                while not exhausted and len(waiting) < in_flight and len(done) < in_flight:
                    try:
                        place, job = next(given)
                    except StopIteration:
                        exhausted = True
                        continue
                    document: dict[str, Any] = {}
                    try:
                        if isinstance(job, InvalidJob):
                            raise job
                        document = document_of(job)
                    except InvalidJob as error:
                        done[place] = Outcome(document, "", None, error)
                    waiting[place] = (job, document, str(uuid.uuid4()))
                after = yield from self._hand_in(waiting, flying, done, priority)
                if flying:
                    yield from self._collect(waiting, flying, done, parts)
                    attempt = 0
                elif after is not None:
                    # This client has no running jobs, so that the place must come from
                    # others.
                    yield Sleep(pause(attempt, after))
                    attempt += 1
                for place in sorted(done):
                    if ordered and place != emitted:
                        break
                    job, _, _ = waiting.pop(place)
                    emitted += 1
                    yield Emit((job, done.pop(place)))
                if exhausted and not waiting:
                    return
        except GeneratorExit:
            raise
        except BaseException:
            with contextlib.suppress(httpx.TransportError, BrinellError):
                ids = list(flying)
                for start in range(0, len(ids), BATCH):
                    body = {"ids": ids[start : start + BATCH]}
                    yield from call(0, "POST", "/v1/batch/cancel", body=body)
            raise

    def _hand_in(
        self,
        waiting: dict[int, tuple[JobLike | InvalidJob, dict[str, Any], str]],
        flying: dict[str, int],
        done: dict[int, Outcome],
        priority: int,
    ) -> Flow[float | None]:
        """Submits the waiting jobs.

        Those refused for lack of a place wait on. Returns when to come again, if any were
        refused.
        """
        under_way = set(flying.values())
        places = [place for place in waiting if place not in under_way and place not in done]
        places = places[:BATCH]
        if not places:
            return None
        members = [
            {"job": waiting[place][1], "idempotency_key": waiting[place][2], "priority": priority}
            for place in places
        ]
        while True:
            try:
                answer = yield from self.json("POST", "/v1/batch/submit", body={"jobs": members})
                break
            except ServiceError as refused:
                if refused.status != 413:
                    raise
                if len(members) == 1:
                    done[places[0]] = Outcome(waiting[places[0]][1], "", None, refused)
                    return None
                # The jobs are too large for one request: send half of them, the rest next time.
                members = members[: len(members) // 2]
                places = places[: len(members)]
        after = None
        for place, item in zip(places, answer["jobs"], strict=True):
            if "job" in item:
                flying[str(item["job"]["id"])] = place
            elif item["status"] in (408, 429) or item["status"] >= 500:
                after = 1.0
            else:
                error = error_of(item["status"], item["problem"])
                done[place] = Outcome(waiting[place][1], "", None, error)
        return after

    def _collect(
        self,
        waiting: dict[int, tuple[JobLike | InvalidJob, dict[str, Any], str]],
        flying: dict[str, int],
        done: dict[int, Outcome],
        parts: str,
    ) -> Flow[None]:
        """Waits a moment for the job in the middle of the queue, and takes what is done."""
        ids = list(flying)
        middle = ids[(len(ids) - 1) // 2]
        yield from call(
            self.retries, "HEAD", f"/v1/jobs/{middle}", params={"wait": f"{LOOK:g}"}, wait=LOOK
        )
        answer = yield from self.json(
            "POST", "/v1/batch/fetch", params={"fields": parts}, body={"ids": ids[:BATCH]}
        )
        for id, item in zip(ids, answer["jobs"], strict=False):
            info = item.get("job")
            place = flying[id]
            document = waiting[place][1]
            if info is None:
                done[place] = Outcome(
                    document, id, None, error_of(item["status"], item["problem"])
                )
            elif info["done"]:
                report = info.get("result")
                error = None if report is not None else failed(info)
                done[place] = Outcome(document, id, report, error)
            else:
                continue
            del flying[id]


def failed(info: Mapping[str, Any]) -> BrinellError:
    """The exception for a job that has ended without a result."""
    problem = info.get("error") or {}
    if problem.get("status") == 422:
        error = error_of(422, problem)
        if isinstance(error, InvalidJob):
            return error
    return JobFailed(str(info["id"]), str(info["status"]), problem)


def event_of(lines: Iterable[str]) -> Event | None:
    """The event in these lines; `None` if there is none."""
    values = {"event": "message", "data": "", "id": ""}
    for line in lines:
        name, _, value = line.partition(":")
        value = value.removeprefix(" ")
        if name == "data" and values["data"]:
            value = values["data"] + "\n" + value
        if name in values:
            values[name] = value
    if not values["data"]:
        return None
    return Event(values["event"], json.loads(values["data"]), values["id"])
