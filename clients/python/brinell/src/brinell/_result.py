"""The answer to a job, with its pictures and its words."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import TYPE_CHECKING

from ._course import Outcome
from ._data import ResultData, archive_of
from ._html import html_of, text_of

if TYPE_CHECKING:
    from ._plot import Plot


class Result(ResultData):
    """The answer to a job. Figures are those of its last step; `steps` has all of them.

    A job of `Client.map` without a result also gives a `Result`: `error` says why, and its figures
    raise it.
    """

    @staticmethod
    def load(path: str | os.PathLike[str]) -> Result:
        """Reads a result that `save` or `brinell solve -o` has written."""
        place = Path(path)
        report = json.loads(place.read_text("utf-8"))
        return Result(report, "", lambda _, step: archive_of(place, step).read_bytes())

    @property
    def plot(self) -> Plot:
        """Pictures: `plot.pressure()`, `.depth()`, `.field()`, `.load_approach()`, `.dent()`,
        `.residual_stress()`, `.passes()`, `.shakedown_map()`, `.fatigue()`, `.hardness()`.
        """
        from ._plot import Plot

        return Plot(self)

    def __repr__(self) -> str:
        return text_of(self)

    def _repr_html_(self) -> str:
        return html_of(self)


def result_of(outcome: Outcome) -> Result:
    """The result of a job that has ended elsewhere; its fields came with it, or did not."""
    return Result(
        outcome.report, outcome.id, lambda id, step: outcome.fields[step - 1], outcome.error
    )
