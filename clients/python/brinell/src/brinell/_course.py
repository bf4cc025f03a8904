"""Many jobs on their way to whoever solves them.

A `Course` takes jobs from an iterator while there is room, leaves out those that a study has
answered, hands in again those that failed by chance, and gives the answers back, in the order of
the jobs or as they are done.
"""

from __future__ import annotations

import hashlib
import json
import os
import uuid
from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol, TypeAlias

from pydantic import BaseModel

from ._errors import BrinellError, Fault, InvalidJob, JobFailed, Unavailable
from ._plain import JobLike, document_of

# Most answers that wait for their turn behind a job that takes longer: some 100 MiB of them.
HELD = 1000

Given: TypeAlias = "JobLike | InvalidJob"
"""A job, or why there is none."""


@dataclass(frozen=True)
class Outcome:
    """The end of a job: its result or its error."""

    document: dict[str, Any]
    id: str
    report: dict[str, Any] | None
    error: BrinellError | None = None
    fields: Sequence[bytes] = ()
    """The archive of each step, where they came with the result."""

    @property
    def solved(self) -> bool:
        """Whether the solver came to its end, converged or not."""
        return self.report is not None and self.report["status"] in ("converged", "not_converged")


class Records(Protocol):
    """Results of other runs."""

    version: str
    """The version of the program whose results these are."""

    def get(self, document: dict[str, Any]) -> Outcome | None:
        """The result of this job, if it is there."""

    def put(self, outcome: Outcome) -> None:
        """Keeps a result."""


@dataclass
class Task:
    """A job that is to be solved."""

    place: int
    """Its number among the jobs, from 0."""
    given: Given
    document: dict[str, Any]
    name: str
    """The same in every run of a study; else of this run alone."""
    retries: int
    """How often it is handed in again if it fails by chance."""
    tries: int = 0
    """How often it was handed in before, in this run and others."""
    is_known: bool = False
    """Whether the service had it before this run."""
    was_lost: bool = False
    """Whether an executor has lost its result before."""

    @property
    def key(self) -> str:
        """Its idempotency key: a service solves what comes twice under one key once."""
        return f"{self.name}.{self.tries}"


class Course:
    """Jobs on their way.

    Args:
        jobs: the jobs, taken as they are needed.
        ordered: whether the answers come in the order of the jobs.
        in_flight: how many tasks are out at a time.
        retries: how often a job is handed in again that failed by chance.
        records: where answers are looked up before, and kept.
    """

    def __init__(
        self,
        jobs: Iterable[Given],
        *,
        ordered: bool,
        in_flight: int,
        retries: int = 0,
        records: Records | None = None,
    ) -> None:
        if isinstance(jobs, (str, os.PathLike, Mapping, BaseModel)):
            raise TypeError("map takes several jobs, as in [job], not one")
        if in_flight < 1:
            raise ValueError(f"in_flight is 1 at least, not {in_flight}")
        self._given = iter(enumerate(jobs))
        self._ordered, self._in_flight = ordered, in_flight
        self._retries, self.records = retries, records
        self._again: deque[Task] = deque()
        self._answers: dict[int, tuple[Given, Outcome]] = {}
        self._out = self._next_place = 0
        self._exhausted = False

    @property
    def over(self) -> bool:
        """Whether every job has its answer, and every answer was taken."""
        return self._exhausted and not (self._out or self._again or self._answers)

    def take(self) -> list[Task]:
        """The tasks for which there is room; each has to be finished."""
        taken: list[Task] = []
        while self._out < self._in_flight:
            task = self._again.popleft() if self._again else self._next()
            if task is None:
                break
            self._out += 1
            taken.append(task)
        return taken

    def _next(self) -> Task | None:
        while not (self._is_full or self._exhausted):
            try:
                place, given = next(self._given)
            except StopIteration:
                self._exhausted = True
                break
            try:
                if isinstance(given, InvalidJob):
                    raise given
                document = document_of(given)
                text = json.dumps(document)
            except (OSError, TypeError, ValueError) as error:
                self._answers[place] = (given, Outcome({}, "", None, _fault_of(error)))
                continue
            known = self.records.get(document) if self.records is not None else None
            if known is None:
                return Task(place, given, document, self._name(text), self._retries)
            self._answers[place] = (given, known)
        return None

    def _name(self, text: str) -> str:
        if self.records is None:
            return str(uuid.uuid4())
        # Of the very text that is sent: a service refuses one key with two texts. Of the version:
        # a service that was renewed keeps the keys of its old one.
        return hashlib.sha256(f"{self.records.version} {text}".encode()).hexdigest()

    @property
    def _is_full(self) -> bool:
        """Whether answers are to be taken before other jobs are looked at."""
        has_turn = not self._ordered or self._next_place in self._answers
        return len(self._answers) >= (self._in_flight if has_turn else HELD)

    def finish(self, task: Task, outcome: Outcome) -> None:
        """Takes the answer to a task."""
        self._out -= 1
        if task.retries > 0 and is_by_chance(outcome.error):
            task.retries -= 1
            task.tries += 1
            self._again.append(task)
            return
        if self.records is not None and outcome.solved:
            self.records.put(outcome)
        self._answers[task.place] = (task.given, outcome)

    def answers(self) -> Iterator[tuple[int, Given, Outcome]]:
        """Place, job and answer of those whose turn it is."""
        for place in sorted(self._answers):
            if self._ordered and place != self._next_place:
                break
            self._next_place += 1
            yield place, *self._answers.pop(place)


def _fault_of(error: Exception) -> InvalidJob:
    """Why there is no job: a file that is not there, what no JSON has."""
    if isinstance(error, InvalidJob):
        return error
    return InvalidJob([Fault("#", "unreadable", f"{type(error).__name__}: {error}")])


def is_by_chance(error: BrinellError | None) -> bool:
    """Whether a job may have another end next time."""
    return isinstance(error, (JobFailed, Unavailable))
