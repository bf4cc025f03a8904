"""The operations of a client, shared by the blocking and the asynchronous one.

A flow is a generator. It yields actions (`Send`, `Sleep`, `Open`, `NextLine`, `Emit`)
and receives the answer or the exception. A client performs flows: one by blocking, the other by
awaiting.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import random
import uuid
from collections.abc import Callable, Generator, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeAlias, TypeVar

import httpx

from ._course import Course, Outcome, Task
from ._errors import (
    BrinellError,
    InvalidJob,
    JobFailed,
    NotFound,
    QuotaExceeded,
    ServiceError,
    StillRunning,
    Unavailable,
    error_of,
)
from ._plain import JobLike, document_of
from ._records import Address, Records

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
# States of jobs without a result that counts.
UNSOLVED = ("failed", "cancelled", "timed_out")
# Why a job that was handed in is not there.
REMOVED = {"detail": "the service made room before its result was read: fewer in_flight need less"}
# First pause before a retry and the longest [s].
PAUSE, LONGEST_PAUSE = 0.2, 8.0


@dataclass(frozen=True)
class Send:
    """A request; its answer is the response, read to its end."""

    method: str
    path: str
    params: Mapping[str, Any] = field(default_factory=dict)
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
    params: Mapping[str, Any] | None = None,
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
            if not is_for_now(response.status_code):
                raise error
        except httpx.TransportError as reason:
            error = unreachable(reason)
        if attempt >= retries:
            raise error
        yield Sleep(pause(attempt, after))
        attempt += 1


def is_for_now(status: int) -> bool:
    """Whether an error of this HTTP status may be gone next time."""
    return status in (408, 429) or status >= 500


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
        self,
        document: dict[str, Any],
        priority: int,
        key: str | None = None,
        waiting: Mapping[str, str] | None = None,
    ) -> Flow[dict[str, Any]]:
        """Hands a job in; with a key that came before, finds the job that came with it."""
        params = {"priority": str(priority)} if priority else {}
        headers = {"Idempotency-Key": key} if key else {}
        answer: dict[str, Any] = yield from self.json(
            "POST",
            "/v1/jobs",
            params={**params, **(waiting or {})},
            body=document,
            headers=headers,
            wait=LOOK if waiting else 0.0,
        )
        return answer

    def look(self, id: str) -> Flow[dict[str, Any]]:
        """Returns the present state of the job."""
        answer: dict[str, Any] = yield from self.json("GET", f"/v1/jobs/{id}")
        return answer

    def jobs(self, status: str | None, tags: Mapping[str, str]) -> Flow[None]:
        """Emits the jobs of the service, the newest first."""
        labels = [f"{name}:{value}" for name, value in tags.items()]
        params: dict[str, Any] = {"limit": str(BATCH), "tag": labels}
        if status is not None:
            params["status"] = status
        while True:
            page = yield from self.json("GET", "/v1/jobs", params=params)
            for info in page["jobs"]:
                yield Emit(info)
            if page["next_cursor"] is None:
                return
            params["cursor"] = page["next_cursor"]

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

    def version(self) -> Flow[str]:
        """The version of the service's program."""
        document = yield from self.json("GET", "/openapi.json")
        return str(document["info"]["version"])

    def records(self, study: Address | None) -> Flow[Records | None]:
        """The results that a study keeps of this version of the program."""
        return None if study is None else Records(study, (yield from self.version()))

    def solve(
        self,
        document: dict[str, Any],
        *,
        parts: str = PARTS,
        events: bool = False,
        fields: bool = False,
        is_wanted: Callable[[], bool] | None = None,
    ) -> Flow[Outcome]:
        """Submits a job and waits for its end, in one request if the job is short.

        If the caller is interrupted, or does not want the result any more, the job is cancelled.
        Emits the events on request.
        """
        key, id = str(uuid.uuid4()), ""
        patience = LONGEST_WAIT if is_wanted is None else LOOK
        try:
            first = {} if events else {"wait": f"{LOOK:g}", "fields": parts}
            info = yield from self.submit(document, 0, key, first)
            id = str(info["id"])
            if events:
                yield from self.events(id)
            while not (info["done"] and ("result" in info or not info["has_result"])):
                if is_wanted is not None and not is_wanted():
                    yield from self.cancel(id)
                params = {"wait": f"{patience:g}", "fields": parts}
                info = yield from self.json("GET", f"/v1/jobs/{id}", params=params, wait=patience)
        except STOPPED:
            with contextlib.suppress(httpx.TransportError, BrinellError):
                # The service may have accepted the job although the answer was lost.
                id = id or str((yield from self.submit(document, 0, key))["id"])
                yield from call(0, "POST", f"/v1/jobs/{id}/cancel")
            raise
        return (yield from self._outcome(document, info, fields))

    def _outcome(
        self, document: dict[str, Any], info: dict[str, Any], with_fields: bool
    ) -> Flow[Outcome]:
        """The end of a job, with its fields if it has any and they are wanted."""
        id, report = str(info["id"]), info.get("result")
        if report is None:
            return Outcome(document, id, None, failed(info))
        fields = []
        if with_fields and (document.get("output") or {}).get("fields"):
            for step in range(len(report["steps"])):
                fields.append((yield from self.fields(id, step + 1)))
        return Outcome(document, id, report, None, fields)

    def map(self, course: Course, parts: str, priority: int = 0) -> Flow[None]:
        """Emits place, job and `Outcome` of each job of a course."""
        waiting: list[Task] = []
        # Tasks by the id of their job: a study has one for all that are alike.
        flying: dict[str, list[Task]] = {}
        attempt = 0
        try:
            while not course.over:
                waiting += course.take()
                after = None
                while waiting and after is None:
                    after = yield from self._hand_in(waiting, flying, course, priority)
                if answers := list(course.answers()):
                    for answer in answers:
                        yield Emit(answer)
                elif flying:
                    yield from self._collect(waiting, flying, course, parts)
                    attempt = 0
                elif after is not None:
                    # This client has no running jobs, so that the place must come from
                    # others.
                    yield Sleep(pause(attempt, after))
                    attempt += 1
        except GeneratorExit:
            raise
        except BaseException:
            with contextlib.suppress(httpx.TransportError, BrinellError):
                # What another run of a study has handed in may be wanted there.
                own = [id for id, tasks in flying.items() if not tasks[0].is_known]
                for ids in batches(own):
                    yield from call(0, "POST", "/v1/batch/cancel", body={"ids": ids})
            raise

    def _hand_in(
        self, waiting: list[Task], flying: dict[str, list[Task]], course: Course, priority: int
    ) -> Flow[float | None]:
        """Submits some of the waiting jobs.

        Those refused for lack of a place wait on. Returns when to come again, if any were
        refused.
        """
        tasks = waiting[:BATCH]
        while True:
            members = [
                {"job": task.document, "idempotency_key": task.key, "priority": priority}
                for task in tasks
            ]
            try:
                answer = yield from self.json("POST", "/v1/batch/submit", body={"jobs": members})
                break
            except ServiceError as refused:
                if refused.status != 413:
                    raise
                if len(tasks) == 1:
                    waiting.remove(tasks[0])
                    course.finish(tasks[0], Outcome(tasks[0].document, "", None, refused))
                    return None
                # The jobs are too large for one request: send half of them, the rest next time.
                tasks = tasks[: len(tasks) // 2]
        after = None
        for task, item in zip(tasks, answer["jobs"], strict=True):
            info = item.get("job")
            if info is None and is_for_now(item["status"]):
                after = 1.0
                continue
            waiting.remove(task)
            if info is not None:
                task.is_known = item.get("replayed", False)
                flying.setdefault(str(info["id"]), []).append(task)
            else:
                error = error_of(item["status"], item["problem"])
                course.finish(task, Outcome(task.document, "", None, error))
        return after

    def _collect(
        self, waiting: list[Task], flying: dict[str, list[Task]], course: Course, parts: str
    ) -> Flow[None]:
        """Waits a moment for the job in the middle of the queue, and takes what is done. What the
        service cannot say now stays, and is asked for again.
        """
        middle = list(flying)[(len(flying) - 1) // 2]
        with contextlib.suppress(NotFound):
            yield from call(
                self.retries, "HEAD", f"/v1/jobs/{middle}", params={"wait": f"{LOOK:g}"}, wait=LOOK
            )
        after = None
        for ids in batches(flying):
            answer = yield from self.json(
                "POST", "/v1/batch/fetch", params={"fields": parts}, body={"ids": ids}
            )
            for id, item in zip(ids, answer["jobs"], strict=True):
                info = item.get("job")
                if info is None and is_for_now(item["status"]):
                    after = 1.0
                    continue
                if info is not None and not info["done"]:
                    continue
                tasks = flying.pop(id)
                document = tasks[0].document
                if info is None:
                    outcome = Outcome(
                        document, id, None, error_of(item["status"], item["problem"])
                    )
                elif tasks[0].is_known and info["status"] in UNSOLVED:
                    # It is of an earlier run, and came to nothing: once more, by another name.
                    for task in tasks:
                        task.tries += 1
                    waiting += tasks
                    continue
                else:
                    keeps = course.records is not None
                    try:
                        outcome = yield from self._outcome(document, info, keeps)
                    except NotFound as gone:
                        outcome = Outcome(document, id, None, gone)
                if isinstance(outcome.error, NotFound):
                    # It was there: it is one that failed by chance.
                    outcome = Outcome(document, id, None, JobFailed(id, "removed", REMOVED))
                for task in tasks:
                    course.finish(task, outcome)
        if after is not None:
            yield Sleep(pause(0, after))


def parts_for(records: Records | None) -> str:
    """What is wanted of results of which figures are wanted: records keep the whole."""
    return FIGURES if records is None else PARTS


def batches(ids: Iterable[str]) -> list[list[str]]:
    """The ids, in lists of as many as one request may have."""
    listed = list(ids)
    return [listed[first : first + BATCH] for first in range(0, len(listed), BATCH)]


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
