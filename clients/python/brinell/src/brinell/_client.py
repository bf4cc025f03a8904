"""Blocking and asynchronous clients, and the jobs that they have submitted."""

from __future__ import annotations

import asyncio
import contextlib
import ipaddress
import os
import time
import urllib.request
from collections.abc import (
    AsyncGenerator,
    AsyncIterator,
    Awaitable,
    Callable,
    Generator,
    Iterable,
    Iterator,
    Mapping,
)
from contextlib import aclosing, closing
from types import TracebackType
from typing import TYPE_CHECKING, Any, Generic, Literal, TypeAlias, TypeVar

import httpx

from ._bars import Bar, Progress
from ._core import (
    PARTS,
    Abandoned,
    Core,
    Emit,
    Event,
    Flow,
    NextLine,
    Open,
    Send,
    parts_for,
)
from ._course import Course, Given, Outcome
from ._fields import Fields
from ._find import Ends, finding
from ._grid import Grid, grid_of, table_of
from ._local import LocalServer
from ._plain import JobLike, document_of
from ._records import Address
from ._result import Result, result_of

if TYPE_CHECKING:
    import pandas as pd

T = TypeVar("T")
Pointers: TypeAlias = str | tuple[str, ...]

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
        self._is_loopback = _is_loopback(httpx.URL(self.url).host)
        self._timeout = timeout
        self._headers = {"Authorization": f"Bearer {api_key}"} if api_key else {}
        self._core = Core(max_retries)

    def _options(self) -> dict[str, Any]:
        limits = httpx.Limits(max_connections=100, max_keepalive_connections=20)
        return {
            "base_url": self.url,
            "headers": self._headers,
            "timeout": self._timeout,
            "limits": limits,
            "trust_env": self._server is None,
            # What is on loopback is reached without the proxies of the environment.
            "mounts": {f"all://{httpx.URL(self.url).netloc.decode()}": None}
            if self._is_loopback
            else None,
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

    def _explained(self, error: httpx.TransportError) -> httpx.TransportError:
        """The same error, or another that says more."""
        if self._server is not None:
            self._server.check()
        host = httpx.URL(self.url).host
        proxies = urllib.request.getproxies()
        proxy = proxies.get(httpx.URL(self.url).scheme) or proxies.get("all")
        if self._is_loopback or not proxy or urllib.request.proxy_bypass(host):
            return error
        # Without the password that it may have.
        place = httpx.URL(proxy if "://" in proxy else f"http://{proxy}").copy_with(userinfo=b"")
        return type(error)(
            f"{error}, by the proxy {place} of the environment (HTTP_PROXY, HTTPS_PROXY, "
            f"ALL_PROXY); NO_PROXY={host} goes around it"
        )

    def __reduce__(self) -> Any:
        raise TypeError(
            "a client stays in its process, with its connections and its local server: "
            "brinell.map(jobs, executor=...) makes one in each process of an executor; "
            "brinell.Client(url, api_key=...) reaches one service from several"
        )

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.url}{' (local)' if self._server else ''}>"


def _is_loopback(host: str) -> bool:
    with contextlib.suppress(ValueError):
        return ipaddress.ip_address(host).is_loopback
    return host == "localhost" or host.endswith(".localhost")


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
        except httpx.TransportError as error:
            raise self._explained(error) from error

    def _open(self, effect: Open) -> httpx.Response:
        client = self._client()
        request = client.build_request(**self._request(effect.request))
        try:
            response = client.send(request, stream=True)
            if response.status_code >= 400:
                response.read()
            return response
        except httpx.TransportError as error:
            raise self._explained(error) from error

    # What it is for.

    def solve(self, job: JobLike, *, progress: bool | Callable[[Event], object] = False) -> Result:
        """Solves a job and returns its result, converged or not. Ctrl-C cancels the job.

        Args:
            job: what to solve.
            progress: show a bar (with tqdm), or call this with every event.
        """
        with Progress(progress) as on:
            flow = self._core.solve(document_of(job), events=on is not None)
            outcome = self._run(flow, on)
        if outcome.error is not None:
            raise outcome.error
        return self._outcome(outcome)

    def submit(self, job: JobLike, *, priority: int = 0) -> Job:
        """Submits a job and returns at once."""
        return Job(self, self._run(self._core.submit(document_of(job), priority)))

    def job(self, id: str) -> Job:
        """Returns a job that this or another client submitted."""
        return Job(self, self._run(self._core.look(id)))

    def jobs(
        self, *, status: str | None = None, tags: Mapping[str, str] | None = None
    ) -> Iterator[Job]:
        """The jobs of this client and of others under the same API key, the newest first.

        Args:
            status: only jobs in this state, as "running".
            tags: only jobs with these labels.
        """
        with closing(self._stream(self._core.jobs(status, tags or {}))) as values:
            for info in values:
                yield Job(self, info)

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
        ordered: bool = False,
        in_flight: int = IN_FLIGHT,
        priority: int = 0,
        retries: int = 0,
        study: Address | None = None,
        progress: bool = False,
    ) -> Iterator[tuple[JobLike, Result]]:
        """Solves many jobs and yields pairs of job and result, as they are done or in order.

        A job that did not converge, failed or is invalid gives a result too: see its
        `converged` and `error`. `brinell.map` has the solvers of an executor.

        Args:
            jobs: the jobs, which are taken from an iterator as they are needed.
            ordered: whether results come in the order of the jobs. Behind a job that takes long,
                up to 1000 results wait.
            in_flight: how many jobs are at the service at a time.
            priority: of each job, −100 to 100; larger goes first.
            retries: how often a job is handed in again that failed by chance.
            study: a folder, or an address of fsspec, that keeps the results: jobs whose results
                are there, of the same version of the program, are not solved again. See
                `brinell.open_study`.
            progress: show a bar (with tqdm).
        """
        records = self._run(self._core.records(study))
        course = Course(
            jobs, ordered=ordered, in_flight=in_flight, retries=retries, records=records
        )
        flow = self._core.map(course, PARTS, priority)
        with Bar(progress, jobs) as count, closing(self._stream(flow)) as values:
            for _, job, outcome in values:
                count()
                yield job, self._outcome(outcome)

    def sweep(
        self,
        job: JobLike | Callable[..., JobLike],
        grid: Grid,
        *,
        in_flight: int = IN_FLIGHT,
        priority: int = 0,
        retries: int = 0,
        study: Address | None = None,
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
            priority: of each job, as in `map`.
            retries: how often a job is handed in again that failed by chance.
            study: where results are kept, as in `map`.
            progress: show a bar (with tqdm).
        """
        points, documents = grid_of(job, grid)
        records = self._run(self._core.records(study))
        course = Course(
            documents, ordered=False, in_flight=in_flight, retries=retries, records=records
        )
        rows: dict[int, Result] = {}
        with Bar(progress, documents) as count:

            def collect(answer: tuple[int, Given, Outcome]) -> None:
                rows[answer[0]] = self._outcome(answer[2])
                count()

            self._run(self._core.map(course, parts_for(records), priority), collect)
        return table_of(points, rows)

    def find(
        self,
        job: JobLike,
        pointer: Pointers,
        figure: str,
        value: float | Literal["least", "most"],
        *,
        between: Ends | None = None,
    ) -> Result:
        """Solves the job with the number with which a figure of the answer is as wanted.

        The search is one job; `found` of its result has every look.

        Args:
            job: the job.
            pointer: the number, as in `/upper/shape/radius`; several get the same value.
            figure: a name among the answers, as `utilization` or `peak_pressure`.
            value: the wanted figure, in the units of the job, a share as a number; or `least` or
                `most`.
            between: the ends of the search; a quarter and four times the number that the job has
                where they are left out.
        """
        return self.solve(finding(job, pointer, figure, value, between))

    def _result(self, report: dict[str, Any], id: str) -> Result:
        return Result(report, id, lambda id, step: self._run(self._core.fields(id, step)))

    def _outcome(self, outcome: Outcome) -> Result:
        if outcome.fields:
            return result_of(outcome)
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
        except httpx.TransportError as error:
            raise self._explained(error) from error

    async def _open(self, effect: Open) -> httpx.Response:
        client = self._client()
        request = client.build_request(**self._request(effect.request))
        try:
            response = await client.send(request, stream=True)
            if response.status_code >= 400:
                await response.aread()
            return response
        except httpx.TransportError as error:
            raise self._explained(error) from error

    # What it is for.

    async def solve(
        self, job: JobLike, *, progress: bool | Callable[[Event], object] = False
    ) -> AsyncResult:
        """As `Client.solve`; a task that is cancelled cancels the job."""
        with Progress(progress) as on:
            flow = self._core.solve(document_of(job), events=on is not None)
            outcome = await self._run(flow, on)
        if outcome.error is not None:
            raise outcome.error
        return self._outcome(outcome)

    async def submit(self, job: JobLike, *, priority: int = 0) -> AsyncJob:
        """As `Client.submit`."""
        return AsyncJob(self, await self._run(self._core.submit(document_of(job), priority)))

    async def job(self, id: str) -> AsyncJob:
        """As `Client.job`."""
        return AsyncJob(self, await self._run(self._core.look(id)))

    async def jobs(
        self, *, status: str | None = None, tags: Mapping[str, str] | None = None
    ) -> AsyncIterator[AsyncJob]:
        """As `Client.jobs`."""
        async with aclosing(self._stream(self._core.jobs(status, tags or {}))) as values:
            async for info in values:
                yield AsyncJob(self, info)

    async def validate(self, job: JobLike) -> dict[str, Any]:
        """As `Client.validate`."""
        answer: dict[str, Any] = (await self._run(self._core.validate(job)))["estimate"]
        return answer

    async def map(
        self,
        jobs: Iterable[JobLike],
        *,
        ordered: bool = False,
        in_flight: int = IN_FLIGHT,
        priority: int = 0,
        retries: int = 0,
        study: Address | None = None,
        progress: bool = False,
    ) -> AsyncIterator[tuple[JobLike, AsyncResult]]:
        """As `Client.map`: `async for job, result in client.map(jobs)`."""
        records = await self._run(self._core.records(study))
        course = Course(
            jobs, ordered=ordered, in_flight=in_flight, retries=retries, records=records
        )
        flow = self._core.map(course, PARTS, priority)
        with Bar(progress, jobs) as count:
            async with aclosing(self._stream(flow)) as values:
                async for _, job, outcome in values:
                    count()
                    yield job, self._outcome(outcome)

    async def sweep(
        self,
        job: JobLike | Callable[..., JobLike],
        grid: Grid,
        *,
        in_flight: int = IN_FLIGHT,
        priority: int = 0,
        retries: int = 0,
        study: Address | None = None,
        progress: bool = False,
    ) -> pd.DataFrame:
        """As `Client.sweep`."""
        points, documents = grid_of(job, grid)
        records = await self._run(self._core.records(study))
        course = Course(
            documents, ordered=False, in_flight=in_flight, retries=retries, records=records
        )
        rows: dict[int, Result] = {}
        with Bar(progress, documents) as count:

            def collect(answer: tuple[int, Given, Outcome]) -> None:
                rows[answer[0]] = self._outcome(answer[2])
                count()

            await self._run(self._core.map(course, parts_for(records), priority), collect)
        return table_of(points, rows)

    async def find(
        self,
        job: JobLike,
        pointer: Pointers,
        figure: str,
        value: float | Literal["least", "most"],
        *,
        between: Ends | None = None,
    ) -> AsyncResult:
        """As `Client.find`."""
        return await self.solve(finding(job, pointer, figure, value, between))

    async def _fetch(self, id: str, step: int) -> bytes:
        return await self._run(self._core.fields(id, step))

    def _result(self, report: dict[str, Any], id: str) -> AsyncResult:
        return AsyncResult(report, id, self._fetch)

    def _outcome(self, outcome: Outcome) -> AsyncResult:
        async def fetch(id: str, step: int) -> bytes:
            return outcome.fields[step - 1] if outcome.fields else await self._fetch(id, step)

        return AsyncResult(outcome.report, outcome.id, fetch, outcome.error)

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
