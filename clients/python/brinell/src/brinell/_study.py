"""The results of a study, to look at."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Any, overload

from ._errors import BrinellError
from ._plain import need
from ._records import Address, Files, read
from ._result import Result, result_of

if TYPE_CHECKING:
    import pandas as pd


class Study:
    """The results that are kept under an address, read when they are asked for.

    A sequence of results, in the order of the names of their files.
    """

    def __init__(self, address: Address) -> None:
        self._files = Files(address, make=False)
        self.names = sorted(self._files.results())
        """The files of the results."""

    def __len__(self) -> int:
        return len(self.names)

    @overload
    def __getitem__(self, place: int) -> Result: ...
    @overload
    def __getitem__(self, place: slice) -> list[Result]: ...
    def __getitem__(self, place: int | slice) -> Result | list[Result]:
        if isinstance(place, slice):
            return [self[one] for one in range(*place.indices(len(self)))]
        return result_of(read(self._files, self.names[place]))

    def __iter__(self) -> Iterator[Result]:
        return (self[place] for place in range(len(self)))

    def job(self, place: int) -> dict[str, Any]:
        """The job behind a result."""
        job: dict[str, Any] = self._files.lines(self.names[place], 2)[1]
        return job

    @cached_property
    def table(self) -> pd.DataFrame:
        """A row for each result, in their order: the figures of the job that differ between jobs,
        by their pointers, the version of the program, and the figures of the last step. Half a
        file has the `status` "not whole".
        """
        pandas = need("pandas", "pandas")
        rows: list[dict[str, Any]] = []
        jobs: list[dict[str, Any]] = []
        for name in self.names:
            try:
                summary, job = self._files.lines(name, 2)
            except BrinellError:
                rows.append({"status": "not whole"})
                jobs.append({})
                continue
            result = Result(summary)
            rows.append({"version": summary["version"], **result.line})
            jobs.append(dict(_leaves(job, "")))
        given = pandas.DataFrame(jobs)
        if len(given):
            given = given.loc[:, given.dropna(how="all").nunique(dropna=False) > 1]
        frame: pd.DataFrame = pandas.concat([given, pandas.DataFrame(rows)], axis=1)
        return frame

    def __repr__(self) -> str:
        return f"<study of {len(self)} results in {self._files.address}>"

    def _repr_html_(self) -> str:
        html: str = self.table.to_html(max_rows=10)
        return html


def open_study(address: Address) -> Study:
    """Opens the results that `map`, `sweep` or `brinell solve --array` have kept.

    Args:
        address: the folder, or an address of fsspec.
    """
    return Study(address)


def _leaves(value: Any, pointer: str) -> Iterator[tuple[str, Any]]:
    """The figures and words of a job by their pointers; measured heights are none."""
    if isinstance(value, dict):
        for name, one in value.items():
            if name != "npy_base64":
                yield from _leaves(one, f"{pointer}/{name}")
    elif isinstance(value, list):
        for place, one in enumerate(value):
            yield from _leaves(one, f"{pointer}/{place}")
    else:
        yield pointer, value
