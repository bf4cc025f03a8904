"""Many jobs on the solvers of this machine, or of an executor."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor
from typing import TYPE_CHECKING, Any

from ._bars import Bar
from ._client import Client
from ._core import PARTS, parts_for
from ._course import Course
from ._grid import Grid, grid_of, table_of
from ._plain import JobLike
from ._records import Address, Records
from ._result import Result, result_of
from ._workers import IN_FLIGHT, over, version_here

if TYPE_CHECKING:
    import pandas as pd


def map(
    jobs: Iterable[JobLike],
    *,
    executor: Executor | None = None,
    ordered: bool = False,
    in_flight: int = IN_FLIGHT,
    retries: int = 0,
    study: Address | None = None,
    progress: bool = False,
) -> Iterator[tuple[JobLike, Result]]:
    """Solves many jobs and yields pairs of job and result, as they are done or in order.

    A job that did not converge, failed or is invalid gives a result too: see its `converged`
    and `error`. To leave the loop stops the jobs.

    Args:
        jobs: the jobs, which are taken from an iterator as they are needed.
        executor: any executor of `concurrent.futures`: that of Dask (`client.get_executor()`),
            loky, `ProcessPoolExecutor`. Each of its processes starts a program of one solver,
            which ends with it. All cores of this machine if left out.
        ordered: whether results come in the order of the jobs. Behind a job that takes long, up
            to 1000 results wait.
        in_flight: how many jobs are at the executor at a time: twice its processes or more.
        retries: how often a job is handed in again that failed by chance.
        study: a folder, or an address of fsspec, that keeps the results: jobs whose results are
            there, of the same version of the program, are not solved again. See `open_study`.
        progress: show a bar (with tqdm).
    """
    if executor is None:
        options: dict[str, Any] = {"in_flight": in_flight, "retries": retries, "study": study}
        with Client() as client:
            yield from client.map(jobs, ordered=ordered, progress=progress, **options)
        return
    records = _records(executor, study)
    course = Course(jobs, ordered=ordered, in_flight=in_flight, retries=retries, records=records)
    with Bar(progress, jobs) as count:
        for _, job, outcome in over(executor, course, PARTS):
            count()
            yield job, result_of(outcome)


def sweep(
    job: JobLike | Callable[..., JobLike],
    grid: Grid,
    *,
    executor: Executor | None = None,
    in_flight: int = IN_FLIGHT,
    retries: int = 0,
    study: Address | None = None,
    progress: bool = False,
) -> pd.DataFrame:
    """Solves a job at each point of a grid; returns a table with a row for each point.

    Args:
        job: a job, in which the grid sets values by pointer, or a function that makes one of
            named values.
        grid: the values, as in `Client.sweep`.
        executor: where the jobs are solved, as in `map`.
        in_flight: how many jobs are at the executor at a time.
        retries: how often a job is handed in again that failed by chance.
        study: where results are kept, as in `map`.
        progress: show a bar (with tqdm).
    """
    if executor is None:
        options: dict[str, Any] = {"in_flight": in_flight, "retries": retries, "study": study}
        with Client() as client:
            return client.sweep(job, grid, progress=progress, **options)
    points, documents = grid_of(job, grid)
    records = _records(executor, study)
    course = Course(
        documents, ordered=False, in_flight=in_flight, retries=retries, records=records
    )
    rows: dict[int, Result] = {}
    with Bar(progress, documents) as count:
        for place, _, outcome in over(executor, course, parts_for(records)):
            rows[place] = result_of(outcome)
            count()
    return table_of(points, rows)


def _records(executor: Executor, study: Address | None) -> Records | None:
    return None if study is None else Records(study, executor.submit(version_here).result())
