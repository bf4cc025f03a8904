"""Grids of jobs, and their tables."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

from pydantic import BaseModel

from ._errors import InvalidJob
from ._plain import JobLike, Quantity, document_of, need, plain, tokens_of, with_values
from ._result import Result

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

Grid: TypeAlias = Mapping[Any, Iterable[Any]]
"""Pointers (or several of them that get the same value, in a tuple), or names of arguments, and
the values of each.
"""


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


def table_of(points: Sequence[Mapping[str, Any]], at: Mapping[int, Result]) -> pd.DataFrame:
    """A row of values and figures for each point, whose results go by its number; figures are
    NaN where there is none.
    """
    pandas = need("pandas", "pandas")
    rows = []
    results = [at[place] for place in range(len(points))]
    errors = [result.error for result in results]
    # If every point is invalid, the mistake is in the job and not at a point of the grid.
    if errors and isinstance(errors[0], InvalidJob) and all(errors):
        raise errors[0]
    for point, result in zip(points, results, strict=True):
        error = str(result.error) if result.error is not None else ""
        # A column named like a figure has the exact values of the grid.
        rows.append({**point, **result.line, "error": error, **point})
    frame: pd.DataFrame = pandas.DataFrame(rows)
    frame.attrs["grid"] = list(points[0]) if points else []
    return frame


def over_grid(table: pd.DataFrame) -> xr.Dataset:
    """The table of a sweep as a data set over its grid.

    A dimension has the last name of its pointer, as `force`; two of one name their pointers.
    """
    need("xarray", "pandas")
    names = table.attrs.get("grid")
    if not names:
        raise ValueError("this table is not that of a sweep, which knows its grid")
    short = {name: name.rsplit("/", 1)[-1] for name in names}
    if len(set(short.values())) < len(short):
        short = {}
    # A figure of the name of a dimension is the same along it.
    figures = table.drop(columns=[s for n, s in short.items() if n != s and s in table])
    data: xr.Dataset = figures.set_index(names).to_xarray().rename(short)
    return data
