"""Blocking and asynchronous clients, and the jobs that they have submitted."""

from __future__ import annotations

import asyncio
import itertools
import os
import time
from collections.abc import (
    AsyncGenerator,
    AsyncIterator,
    Awaitable,
    Callable,
    Generator,
    Iterable,
    Iterator,
    Mapping,
    Sequence,
)
from contextlib import aclosing, closing
from types import TracebackType
from typing import TYPE_CHECKING, Any, Generic, TypeAlias, TypeVar

import httpx
from pydantic import BaseModel

from ._core import (
    FIGURES,
    PARTS,
    Abandoned,
    Core,
    Emit,
    Event,
    Flow,
    NextLine,
    Open,
    Outcome,
    Send,
)
from ._errors import InvalidJob
from ._fields import Fields
from ._find import Figure, Found, figure_of, found_of, number_at, search, with_value
from ._local import LocalServer
from ._plain import JobLike, Quantity, document_of, need, plain, tokens_of, with_values
from ._result import Result
from ._step import NO_FIGURES

if TYPE_CHECKING:
    import pandas as pd

T = TypeVar("T")
Pointers: TypeAlias = str | tuple[str, ...]
Grid: TypeAlias = Mapping[Any, Iterable[Any]]
"""Pointers (or several of them that get the same value, in a tuple), or names of arguments, and
the values of each.
"""

# Seconds for a connection and for each piece of an answer.
TIMEOUT = 30.0
# Jobs that are at the service at a time: enough to keep it busy while results travel.
IN_FLIGHT = 64


class _Connection:
    """Address of the service, and settings of the requests to it."""

    def __init__(
        self,
        url: str | None,
        api_key: str | None,
        timeout: float,
        max_retries: int,
        program: str | os.PathLike[str] | None,
        workers: int | None,
        max_body: int | None,
    ) -> None:
        url = url or os.environ.get("BRINELL_URL")
        self._server = None if url else LocalServer(program, workers, max_body)
        if self._server is not None:
            url, api_key = self._server.url, self._server.key
        else:
            api_key = api_key or os.environ.get("BRINELL_API_KEY")
        self.url = str(url).rstrip("/")
        """Where the service is."""
        self._timeout = timeout
        self._headers = {"Authorization": f"Bearer {api_key}"} if api_key else {}
        self._core = Core(max_retries)

    def _options(self) -> dict[str, Any]:
        limits = httpx.Limits(max_connections=100, max_keepalive_connections=20)
        # A server on loopback is reached without the proxies of the environment.
        return {
            "base_url": self.url,
            "headers": self._headers,
            "timeout": self._timeout,
            "limits": limits,
            "trust_env": self._server is None,
        }

    def _request(self, send: Send) -> dict[str, Any]:
        return {
            "method": send.method,
            "url": send.path,
            "params": dict(send.params),
            "content": send.body,
            "headers": dict(send.headers),
            "timeout": httpx.Timeout(self._timeout, read=self._timeout + send.wait),
        }

    @property
    def log(self) -> str | None:
        """The log of the local server, if there is one."""
        return str(self._server.log) if self._server else None

    def _check_server(self) -> None:
        if self._server is not None:
            self._server.check()

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.url}{' (local)' if self._server else ''}>"


class Client(_Connection):
    """A blocking client of the service.

    Args:
        url: address of the service, by default `BRINELL_URL`; without either, a local server
            is started on this machine
            and ends with this process.
        api_key: API key, by default `BRINELL_API_KEY`.
        timeout: seconds for a connection and for each piece of an answer; waits for results
            come on top.
        max_retries: how often a request is repeated after a connection error, 408, 429 or 5xx.
        program: the `brinell` program for the local server, if it is not found by itself.
        workers: jobs that the local server solves at the same time; one per core if left out.
        max_body: bytes that a request to the local server may have; 64 MiB if left out, two
            surfaces of 1024 × 1024 heights.
    """

    def __init__(
        self,
        url: str | None = None,
        *,
        api_key: str | None = None,
        timeout: float = TIMEOUT,
        max_retries: int = 2,
        program: str | os.PathLike[str] | None = None,
        workers: int | None = None,
        max_body: int | None = None,
    ) -> None:
        super().__init__(url, api_key, timeout, max_retries, program, workers, max_body)
        self._http: httpx.Client | None = None
        self._pid = 0

    # Performing flows.

    def _client(self) -> httpx.Client:
        # A forked process opens connections of its own.
        if self._http is None or self._pid != os.getpid():
            self._http = httpx.Client(**self._options())
            self._pid = os.getpid()
        return self._http

    def _stream(self, flow: Flow[T], end: list[T] | None = None) -> Generator[Any, None, None]:
        """Yields the values that a flow emits; passes its return value to `end`."""
        opened: httpx.Response | None = None
        lines: Iterator[str] = iter(())
        answer: Any = None
        error: BaseException | None = None
        try:
            while True:
                effect = flow.send(answer) if error is None else flow.throw(error)
                answer = error = None
                try:
                    if isinstance(effect, Emit):
                        try:
                            yield effect.value
                        except GeneratorExit:
                            raise Abandoned from None
                    elif isinstance(effect, Send):
                        answer = self._send(effect)
                    elif isinstance(effect, Open):
                        if opened is not None:
                            opened.close()
                        opened = answer = self._open(effect)
                        lines = opened.iter_lines()
                    elif isinstance(effect, NextLine):
                        answer = next(lines, None)
                    else:
                        time.sleep(effect.seconds)
                except BaseException as reason:
                    error = reason
        except StopIteration as done:
            if end is not None:
                end.append(done.value)
        except Abandoned:
            pass
        finally:
            if opened is not None:
                opened.close()

    def _run(self, flow: Flow[T], on: Callable[[Any], object] | None = None) -> T:
        end: list[T] = []
        with closing(self._stream(flow, end)) as values:
            for value in values:
                if on is not None:
                    on(value)
        return end[0]

    def _send(self, send: Send) -> httpx.Response:
        try:
            return self._client().request(**self._request(send))
        except httpx.TransportError:
            self._check_server()
            raise

    def _open(self, effect: Open) -> httpx.Response:
        client = self._client()
        request = client.build_request(**self._request(effect.request))
        try:
            response = client.send(request, stream=True)
            if response.status_code >= 400:
                response.read()
            return response
        except httpx.TransportError:
            self._check_server()
            raise

    # What it is for.

    def solve(self, job: JobLike, *, progress: bool | Callable[[Event], object] = False) -> Result:
        """Solves a job and returns its result, converged or not. Ctrl-C cancels the job.

        Args:
            job: what to solve.
            progress: show a bar (with tqdm), or call this with every event.
        """
        with _Progress(progress) as on:
            id, report = self._run(self._core.solve(document_of(job), on is not None), on)
        return self._result(report, id)

    def submit(self, job: JobLike, *, priority: int = 0) -> Job:
        """Submits a job and returns at once."""
        return Job(self, self._run(self._core.submit(document_of(job), priority)))

    def job(self, id: str) -> Job:
        """Returns a job that this or another client submitted."""
        return Job(self, self._run(self._core.look(id)))

    def validate(self, job: JobLike) -> dict[str, Any]:
        """Checks a job and returns its estimated cost: `equations`, `bytes`, `result_bytes`.

        Raises `InvalidJob` if it has faults.
        """
        answer: dict[str, Any] = self._run(self._core.validate(job))["estimate"]
        return answer

    def _hardening_curve(self, test: dict[str, Any]) -> dict[str, Any]:
        return self._run(self._core.hardening_curve(test))

    def map(
        self,
        jobs: Iterable[JobLike],
        *,
        ordered: bool = True,
        in_flight: int = IN_FLIGHT,
        progress: bool = False,
    ) -> Iterator[tuple[JobLike, Result]]:
        """Solves many jobs and yields pairs of job and result, in order or as they are done.

        A job that did not converge, failed or is invalid gives a result too: see its
        `converged` and `error`.

        Args:
            jobs: the jobs, which are taken from an iterator as they are needed.
            ordered: whether results come in the order of the jobs.
            in_flight: how many jobs are at the service at a time.
            progress: show a bar (with tqdm).
        """
        flow = self._core.map(jobs, ordered, in_flight, PARTS)
        with _Bar(progress, jobs) as count, closing(self._stream(flow)) as values:
            for job, outcome in values:
                count()
                yield job, self._outcome(outcome)

    def sweep(
        self,
        job: JobLike | Callable[..., JobLike],
        grid: Grid,
        *,
        in_flight: int = IN_FLIGHT,
        progress: bool = False,
    ) -> pd.DataFrame:
        """Solves a job at each point of a grid; returns a table with a row for each point.

        Args:
            job: a job, in which the grid sets values by pointer, or a function that makes one
                of named values.
            grid: the values by pointer, as in `{"/load/force": [100, 200]}`; a tuple of
                pointers sets the same value at
                each of them. For a function, the values by the names of its arguments.
            in_flight: how many jobs are at the service at a time.
            progress: show a bar (with tqdm).
        """
        points, documents = grid_of(job, grid)
        flow = self._core.map(documents, True, in_flight, FIGURES)
        rows: list[Result] = []

        def collect(pair: tuple[JobLike, Outcome]) -> None:
            rows.append(self._outcome(pair[1]))
            count()

        with _Bar(progress, documents) as count:
            self._run(flow, collect)
        return table_of(points, rows)

    def find(
        self,
        job: JobLike,
        pointer: Pointers,
        figure: Figure,
        value: float,
        *,
        tolerance: float = 2e-3,
        most: int = 30,
    ) -> Found[Result]:
        """Looks for the value of a number with which a figure of the answer is as wanted.

        Each look is a job; the search begins at the number that the job has, goes to both sides
        until the figure passes the wanted value, and closes in on it.

        Args:
            job: the job to begin with.
            pointer: the number, as in `/upper/shape/radius`; several get the same value.
            figure: a name among the answers, as `utilization` or `peak_pressure`, or a function
                of the result.
            value: the wanted figure: in the units of the job; a share as a number.
            tolerance: how far the figure may be off, relative to the wanted one.
            most: most jobs.
        """
        pointers = (pointer,) if isinstance(pointer, str) else pointer
        document, begin = number_at(job, pointers[0])
        steps = search(begin, value, tolerance, most)
        results: dict[float, Result] = {}
        at = next(steps)
        try:
            while True:
                results[at] = self.solve(with_value(document, pointers, at))
                at = steps.send(figure_of(results[at], figure))
        except StopIteration as end:
            return found_of(end.value, results, value, tolerance)

    def _result(self, report: dict[str, Any], id: str) -> Result:
        return Result(report, id, lambda id, step: self._run(self._core.fields(id, step)))

    def _outcome(self, outcome: Outcome) -> Result:
        fetch = lambda id, step: self._run(self._core.fields(id, step))  # noqa: E731
        return Result(outcome.report, outcome.id, fetch, outcome.error)

    def close(self) -> None:
        """Closes the connections, and the local server if there is one."""
        if self._http is not None:
            self._http.close()
            self._http = None
        if self._server is not None:
            self._server.close()

    def __enter__(self) -> Client:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()


class AsyncResult(Result):
    """A result whose fields are awaited: `await result.fetch_fields()`, then `result.fields()` and
    `result.plot.field()`.
    """

    def __init__(
        self,
        report: dict[str, Any] | None,
        id: str = "",
        fetch: Callable[[str, int], Awaitable[bytes]] | None = None,
        error: Exception | None = None,
    ) -> None:
        super().__init__(report, id, None, error)  # type: ignore[arg-type]
        self._await = fetch
        self._fields: dict[int, Fields] = {}

    async def fetch_fields(self, step: int = -1) -> Fields:
        """Fetches mesh and stresses of a step for `fields`."""
        assert self._await is not None
        place = self.steps[step].place
        if place not in self._fields:
            data = await self._await(self.id, place)
            self._fields[place] = Fields.of(data, bool(self.data["mesh"]["symmetric"]))
        return self._fields[place]

    def fields(self, step: int = -1) -> Fields:
        """Returns mesh and stresses of a step that `fetch_fields` has fetched."""
        try:
            return self._fields[self.steps[step].place]
        except KeyError:
            raise RuntimeError("await result.fetch_fields(step) first") from None

    def __getstate__(self) -> dict[str, Any]:
        return {**super().__getstate__(), "_await": None}


class AsyncClient(_Connection):
    """An asynchronous client with the methods of `Client`."""

    def __init__(
        self,
        url: str | None = None,
        *,
        api_key: str | None = None,
        timeout: float = TIMEOUT,
        max_retries: int = 2,
        program: str | os.PathLike[str] | None = None,
        workers: int | None = None,
        max_body: int | None = None,
    ) -> None:
        super().__init__(url, api_key, timeout, max_retries, program, workers, max_body)
        self._http: httpx.AsyncClient | None = None

    # Performing flows.

    def _client(self) -> httpx.AsyncClient:
        if self._http is None:
            self._http = httpx.AsyncClient(**self._options())
        return self._http

    async def _stream(
        self, flow: Flow[T], end: list[T] | None = None
    ) -> AsyncGenerator[Any, None]:
        """Yields the values that a flow emits; passes its return value to `end`."""
        opened: httpx.Response | None = None
        lines: AsyncIterator[str] | None = None
        answer: Any = None
        error: BaseException | None = None
        try:
            while True:
                effect = flow.send(answer) if error is None else flow.throw(error)
                answer = error = None
                try:
                    if isinstance(effect, Emit):
                        try:
                            yield effect.value
                        except GeneratorExit:
                            raise Abandoned from None
                    elif isinstance(effect, Send):
                        answer = await self._send(effect)
                    elif isinstance(effect, Open):
                        if opened is not None:
                            await opened.aclose()
                        opened = answer = await self._open(effect)
                        lines = opened.aiter_lines()
                    elif isinstance(effect, NextLine):
                        answer = await anext(lines, None) if lines is not None else None
                    else:
                        await asyncio.sleep(effect.seconds)
                except BaseException as reason:
                    error = reason
        except StopIteration as done:
            if end is not None:
                end.append(done.value)
        except Abandoned:
            pass
        finally:
            if opened is not None:
                await opened.aclose()

    async def _run(self, flow: Flow[T], on: Callable[[Any], object] | None = None) -> T:
        end: list[T] = []
        async with aclosing(self._stream(flow, end)) as values:
            async for value in values:
                if on is not None:
                    on(value)
        return end[0]

    async def _send(self, send: Send) -> httpx.Response:
        try:
            return await self._client().request(**self._request(send))
        except httpx.TransportError:
            self._check_server()
            raise

    async def _open(self, effect: Open) -> httpx.Response:
        client = self._client()
        request = client.build_request(**self._request(effect.request))
        try:
            response = await client.send(request, stream=True)
            if response.status_code >= 400:
                await response.aread()
            return response
        except httpx.TransportError:
            self._check_server()
            raise

    # What it is for.

    async def solve(
        self, job: JobLike, *, progress: bool | Callable[[Event], object] = False
    ) -> AsyncResult:
        """As `Client.solve`; a task that is cancelled cancels the job."""
        with _Progress(progress) as on:
            id, report = await self._run(self._core.solve(document_of(job), on is not None), on)
        return self._result(report, id)

    async def submit(self, job: JobLike, *, priority: int = 0) -> AsyncJob:
        """As `Client.submit`."""
        return AsyncJob(self, await self._run(self._core.submit(document_of(job), priority)))

    async def job(self, id: str) -> AsyncJob:
        """As `Client.job`."""
        return AsyncJob(self, await self._run(self._core.look(id)))

    async def validate(self, job: JobLike) -> dict[str, Any]:
        """As `Client.validate`."""
        answer: dict[str, Any] = (await self._run(self._core.validate(job)))["estimate"]
        return answer

    async def map(
        self,
        jobs: Iterable[JobLike],
        *,
        ordered: bool = True,
        in_flight: int = IN_FLIGHT,
        progress: bool = False,
    ) -> AsyncIterator[tuple[JobLike, AsyncResult]]:
        """As `Client.map`: `async for job, result in client.map(jobs)`."""
        flow = self._core.map(jobs, ordered, in_flight, PARTS)
        with _Bar(progress, jobs) as count:
            async with aclosing(self._stream(flow)) as values:
                async for job, outcome in values:
                    count()
                    yield job, self._outcome(outcome)

    async def sweep(
        self,
        job: JobLike | Callable[..., JobLike],
        grid: Grid,
        *,
        in_flight: int = IN_FLIGHT,
        progress: bool = False,
    ) -> pd.DataFrame:
        """As `Client.sweep`."""
        points, documents = grid_of(job, grid)
        flow = self._core.map(documents, True, in_flight, FIGURES)
        rows: list[Result] = []

        def collect(pair: tuple[JobLike, Outcome]) -> None:
            rows.append(self._outcome(pair[1]))
            count()

        with _Bar(progress, documents) as count:
            await self._run(flow, collect)
        return table_of(points, rows)

    async def find(
        self,
        job: JobLike,
        pointer: Pointers,
        figure: Figure,
        value: float,
        *,
        tolerance: float = 2e-3,
        most: int = 30,
    ) -> Found[AsyncResult]:
        """As `Client.find`."""
        pointers = (pointer,) if isinstance(pointer, str) else pointer
        document, begin = number_at(job, pointers[0])
        steps = search(begin, value, tolerance, most)
        results: dict[float, AsyncResult] = {}
        at = next(steps)
        try:
            while True:
                results[at] = await self.solve(with_value(document, pointers, at))
                at = steps.send(figure_of(results[at], figure))
        except StopIteration as end:
            return found_of(end.value, results, value, tolerance)

    async def _fetch(self, id: str, step: int) -> bytes:
        return await self._run(self._core.fields(id, step))

    def _result(self, report: dict[str, Any], id: str) -> AsyncResult:
        return AsyncResult(report, id, self._fetch)

    def _outcome(self, outcome: Outcome) -> AsyncResult:
        return AsyncResult(outcome.report, outcome.id, self._fetch, outcome.error)

    async def close(self) -> None:
        """Closes the connections, and the local server if there is one."""
        if self._http is not None:
            await self._http.aclose()
            self._http = None
        if self._server is not None:
            self._server.close()

    async def __aenter__(self) -> AsyncClient:
        return self

    async def __aexit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        await self.close()


C = TypeVar("C", bound=_Connection)


class _Job(Generic[C]):
    """A job that has been handed in."""

    def __init__(self, client: C, info: dict[str, Any]) -> None:
        self._client = client
        self.info = info
        """The job as the service last told of it."""

    @property
    def id(self) -> str:
        """Its name at the service."""
        return str(self.info["id"])

    def __repr__(self) -> str:
        return f"<job {self.id}: {self.info['status']}>"


class Job(_Job[Client]):
    """A job that has been handed in."""

    def refresh(self) -> Job:
        """Requests the state of the job again, unless it is done."""
        if not self.info["done"]:
            self.info = self._client._run(self._client._core.look(self.id))
        return self

    @property
    def status(self) -> str:
        """The present state: `queued`, `running`, `succeeded`, `not_converged`, `failed`,
        `cancelled`, `timed_out`.
        """
        return str(self.refresh().info["status"])

    @property
    def done(self) -> bool:
        """Whether it has ended."""
        return bool(self.refresh().info["done"])

    @property
    def progress(self) -> dict[str, Any]:
        """Its progress: the number of `iterations`, and the `latest` of them."""
        answer: dict[str, Any] = self.refresh().info["progress"]
        return answer

    def wait(self, timeout: float | None = None) -> bool:
        """Waits for its end, at most `timeout` seconds. Returns whether it has ended."""
        self.info = self._client._run(self._client._core.wait(self.id, timeout))
        return bool(self.info["done"])

    def result(self, timeout: float | None = None) -> Result:
        """Waits for the result and returns it.

        `StillRunning` if it is not there in so many seconds, `JobFailed` if there is none.
        """
        return self._client._result(
            self._client._run(self._client._core.report(self.id, timeout)), self.id
        )

    def cancel(self) -> Job:
        """Stops the job within one iteration; it keeps the results so far."""
        self.info = self._client._run(self._client._core.cancel(self.id))
        return self

    def events(self) -> Iterator[Event]:
        """Its events from the beginning: a `state` now and then, an `iteration` each, and the last
        `state`.
        """
        return self._client._stream(self._client._core.events(self.id))


class AsyncJob(_Job[AsyncClient]):
    """A job that has been handed in.

    `info` has the state of the job at the last request; `refresh` requests it again.
    """

    @property
    def status(self) -> str:
        """The state at the last request."""
        return str(self.info["status"])

    @property
    def done(self) -> bool:
        """Whether it had ended at the last request."""
        return bool(self.info["done"])

    @property
    def progress(self) -> dict[str, Any]:
        """The progress at the last request."""
        answer: dict[str, Any] = self.info["progress"]
        return answer

    async def refresh(self) -> AsyncJob:
        """Requests the state of the job again, unless it is done."""
        if not self.info["done"]:
            self.info = await self._client._run(self._client._core.look(self.id))
        return self

    async def wait(self, timeout: float | None = None) -> bool:
        """Waits for its end, at most `timeout` seconds. Returns whether it has ended."""
        self.info = await self._client._run(self._client._core.wait(self.id, timeout))
        return bool(self.info["done"])

    async def result(self, timeout: float | None = None) -> AsyncResult:
        """Waits for the result and returns it."""
        return self._client._result(
            await self._client._run(self._client._core.report(self.id, timeout)), self.id
        )

    async def cancel(self) -> AsyncJob:
        """Stops the job within one iteration; it keeps the results so far."""
        self.info = await self._client._run(self._client._core.cancel(self.id))
        return self

    def events(self) -> AsyncIterator[Event]:
        """Its events from the beginning to its end."""
        return self._client._stream(self._client._core.events(self.id))


# Grids.


def grid_of(
    job: JobLike | Callable[..., JobLike], grid: Grid
) -> tuple[list[dict[str, Any]], list[JobLike | InvalidJob]]:
    """The points of a grid with named values, and the job at each point, or why
    there is none.
    """
    axes = {key: _values(key, values) for key, values in grid.items()}
    names = {key: key if isinstance(key, str) else key[0] for key in axes}
    base = None if callable(job) else document_of(job)
    points: list[dict[str, Any]] = []
    documents: list[JobLike | InvalidJob] = []
    for values in itertools.product(*axes.values()):
        point = dict(zip(axes, values, strict=True))
        points.append({names[key]: _cell(names[key], v, base) for key, v in point.items()})
        try:
            if base is None:
                assert callable(job)
                documents.append(job(**point))
            else:
                placed = {
                    one: value
                    for key, value in point.items()
                    for one in ([key] if isinstance(key, str) else key)
                }
                documents.append(with_values(base, placed))
        except InvalidJob as error:
            documents.append(error)
    return points, documents


def _values(key: Any, values: Any) -> list[Any]:
    if isinstance(values, (str, Mapping, BaseModel)) or not isinstance(values, Iterable):
        raise TypeError(f"a grid has a list of values for {key!r}, not {values!r}")
    return list(values)


def _cell(name: str, value: Any, base: Mapping[str, Any] | None) -> Any:
    """Converts a value for a table: numbers and words stay, the rest becomes text.

    A quantity is given in the unit of the job, where the name is a pointer into it.
    """
    if isinstance(value, Quantity):
        value = value if base is None else plain(value, base, tokens_of(name)[-1])
    elif hasattr(value, "dtype"):
        value = getattr(value, "item", lambda: value)()
    elif not isinstance(value, (int, float, str, bool)):
        value = plain(value)
    return value if isinstance(value, (int, float, str, bool)) else str(value)


def table_of(points: Sequence[Mapping[str, Any]], results: Sequence[Result]) -> pd.DataFrame:
    """A row of values and figures for each point; figures are NaN where there is no result."""
    pandas = need("pandas", "pandas")
    rows = []
    errors = [result.error for result in results]
    # If every point is invalid, the mistake is in the job and not at a point of the grid.
    if errors and isinstance(errors[0], InvalidJob) and all(errors):
        raise errors[0]
    for point, result in zip(points, results, strict=True):
        figures = (
            result.last.figures() if result.error is None and result.steps else dict(NO_FIGURES)
        )
        error = str(result.error) if result.error is not None else ""
        row = {**point, **figures, "status": result.status, "error": error}
        # A column named like a figure has the exact values of the grid.
        rows.append({**row, **point})
    frame: pd.DataFrame = pandas.DataFrame(rows)
    return frame


# Bars.


class _Progress:
    """A progress bar or a callback for the events of one job; `None` without either."""

    def __init__(self, wanted: bool | Callable[[Event], object]) -> None:
        self._wanted = wanted
        self._bar: Any = None

    def __enter__(self) -> Callable[[Event], object] | None:
        if callable(self._wanted):
            return self._wanted
        self._bar = _tqdm(unit=" iterations") if self._wanted else None
        return self._show if self._bar is not None else None

    def _show(self, event: Event) -> None:
        if event.kind == "iteration":
            self._bar.update()
            residual = event.data["equilibrium_residual"]
            self._bar.set_postfix_str(f"out of balance {residual:.1e}", refresh=False)
        else:
            self._bar.set_description_str(str(event.data["status"]) + " ", refresh=False)

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.close()


class _Bar:
    """A bar for many jobs."""

    def __init__(self, wanted: bool, jobs: Any) -> None:
        total = len(jobs) if hasattr(jobs, "__len__") else None
        self._bar = _tqdm(total=total, unit=" jobs") if wanted else None

    def __enter__(self) -> Callable[[], object]:
        return self._bar.update if self._bar is not None else lambda: None

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.close()


def _tqdm(**options: Any) -> Any:
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    return tqdm(**options)
