"""A job that asks for an input: `Client.find` writes it, the service solves it."""

from __future__ import annotations

from typing import Any, Literal

from ._plain import JobLike, document_of, tokens_of

Ends = tuple[float, float]

# Ends of a search over the number that the job has, where none are given.
_AROUND = (0.25, 4.0)


def finding(
    job: JobLike,
    pointer: str | tuple[str, ...],
    figure: str,
    value: float | Literal["least", "most"],
    between: Ends | None,
) -> dict[str, Any]:
    """The job that asks for the number with which a figure is as wanted."""
    document = document_of(job)
    pointers = [pointer] if isinstance(pointer, str) else list(pointer)
    if between is None:
        number = _number(document, pointers[0])
        between = (_AROUND[0] * number, _AROUND[1] * number)
    until = {value: figure} if isinstance(value, str) else {figure: float(value)}
    return {**document, "find": {"vary": pointers, "between": list(between), "until": until}}


def _number(document: dict[str, Any], pointer: str) -> float:
    place: Any = document
    for token in tokens_of(pointer):
        place = place[int(token)] if isinstance(place, list) else (place or {}).get(token)
    if not isinstance(place, int | float) or isinstance(place, bool) or place <= 0:
        raise ValueError(f"{pointer!r} is no number above 0 of the job: give `between`")
    return float(place)
