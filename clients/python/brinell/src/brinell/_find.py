"""The value of a number of a job for which a figure of its answer has a value.

The search is a generator, as the flows of `_core` are: it yields values to be looked at and
receives the figure of each. It brackets a change of sign, then closes the bracket by secants
that never leave it (Illinois).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Generator, Mapping
from dataclasses import dataclass, field
from typing import Any, Generic, TypeAlias, TypeVar

from ._plain import JobLike, document_of, tokens_of, with_values
from ._result import Result

R = TypeVar("R", bound=Result)
Figure: TypeAlias = str | Callable[[Any], float]

# Largest ratio of both ends to the beginning before there is a bracket.
REACH = 64.0


@dataclass(frozen=True)
class Found(Generic[R]):
    """What a search has come to.

    Attributes:
        value: the value of the number, in the units of the job.
        figure: the figure that the job has with it.
        result: the result of this job.
        converged: whether the figure is as wanted, within the tolerance.
        looks: every value that was looked at, and its figure; NaN where there was none.
    """

    value: float
    figure: float
    result: R
    converged: bool
    looks: list[tuple[float, float]] = field(repr=False)


def figure_of(result: Result, figure: Figure) -> float:
    """Returns a figure of the last step: by its name, or by a function. NaN where the step is not
    an answer.
    """
    if not result.steps or not result.last.converged:
        return math.nan
    if callable(figure):
        return float(figure(result))
    try:
        return result[figure]
    except KeyError as unknown:
        raise ValueError(unknown.args[0]) from None


def number_at(job: JobLike, pointer: str) -> tuple[Mapping[str, Any], float]:
    """Returns the document of a job and its number at a pointer."""
    document = document_of(job)
    place: Any = document
    for token in tokens_of(pointer):
        place = place[int(token)] if isinstance(place, list) else (place or {}).get(token)
    if not isinstance(place, int | float) or isinstance(place, bool) or place <= 0:
        raise ValueError(f"{pointer!r} is no number above 0 of the job, where a search begins")
    return document, float(place)


def search(
    begin: float, wanted: float, tolerance: float, most: int
) -> Generator[float, float, list[tuple[float, float]]]:
    """Yields values and takes their figures; returns all of them, the best one last."""
    looks: list[tuple[float, float]] = []
    good = tolerance * (abs(wanted) or 1.0)

    def off(at: int) -> float:
        return looks[at][1] - wanted

    def look(value: float) -> Generator[float, float, int]:
        looks.append((value, (yield value)))
        return len(looks) - 1

    def done() -> bool:
        return len(looks) >= most or any(abs(figure - wanted) <= good for _, figure in looks)

    first = yield from look(begin)
    bracket: tuple[int, int] | None = None
    ends = {-1: first, 1: first}
    ratio = 1.5
    while bracket is None and ratio <= REACH and not done():
        for way in (-1, 1):
            if bracket is None and not done():
                one = yield from look(begin * ratio**way)
                if off(one) * off(ends[way]) < 0:
                    low, high = sorted((ends[way], one), key=lambda at: looks[at][0])
                    bracket = (low, high)
                elif not math.isnan(off(one)):
                    ends[way] = one
        ratio *= 1.6
    if bracket is not None:
        low, high = bracket
        weights, side = [1.0, 1.0], 0
        while not done():
            a, b = weights[0] * off(low), weights[1] * off(high)
            one = yield from look((a * looks[high][0] - b * looks[low][0]) / (a - b))
            if math.isnan(off(one)):
                break
            if off(one) * off(low) > 0:
                low = one
                weights = [1.0, weights[1] / 2 if side == 1 else 1.0]
                side = 1
            else:
                high = one
                weights = [weights[0] / 2 if side == -1 else 1.0, 1.0]
                side = -1
    best = min(looks, key=lambda one: math.inf if math.isnan(one[1]) else abs(one[1] - wanted))
    return [*(one for one in looks if one != best), best]


def with_value(document: Mapping[str, Any], pointers: tuple[str, ...], value: float) -> JobLike:
    """The document with a value at every pointer."""
    return with_values(document, dict.fromkeys(pointers, value))


def found_of(
    looks: list[tuple[float, float]], results: Mapping[float, R], wanted: float, tolerance: float
) -> Found[R]:
    """What the looks of a search, the best one last, have come to."""
    value, figure = looks[-1]
    good = abs(figure - wanted) <= tolerance * (abs(wanted) or 1.0)
    return Found(value, figure, results[value], good, sorted(looks))
