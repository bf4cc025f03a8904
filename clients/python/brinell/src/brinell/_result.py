"""The answer to a job, with its pictures and its words."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._data import ResultData
from ._html import html_of, text_of

if TYPE_CHECKING:
    from ._plot import Plot


class Result(ResultData):
    """The answer to a job. Figures are those of its last step; `steps` has all of them.

    A job of `Client.map` without a result also gives a `Result`: `error` says why, and its figures
    raise it.
    """

    @property
    def plot(self) -> Plot:
        """Pictures: `plot.pressure()`, `.depth()`, `.field()`, `.load_approach()`, `.dent()`,
        `.residual_stress()`, `.passes()`, `.shakedown_map()`, `.hardness()`.
        """
        from ._plot import Plot

        return Plot(self)

    def __repr__(self) -> str:
        return text_of(self)

    def _repr_html_(self) -> str:
        return html_of(self)
