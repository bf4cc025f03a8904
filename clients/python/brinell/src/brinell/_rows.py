"""Figures of a result, each a row, by name."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import asdict, dataclass, fields
from typing import TYPE_CHECKING, Any

from ._plain import need

if TYPE_CHECKING:
    import pandas as pd

# Errors in words, as figures.
_WORDS = {"given": 0.0, "exact": 0.0, "not_bounded": math.nan}


@dataclass(frozen=True)
class Row:
    """A figure as the service answers it. Unknown numbers are NaN."""

    name: str
    label: str
    body: str | None
    """`upper`, `lower`, `both` of bodies that are alike; None of the contact."""
    value: float
    quantity: str
    """`length`, `stress`, `force` and so on; a `strain` and a `ratio` are shown in per cent."""
    unit: str
    error: float
    """Bound of the relative error; 0 of what is given or exact, NaN of what nothing bounds."""
    reason: str
    """`given`, `exact`, or why nothing bounds the error; empty beside a bound."""
    at_least: float
    """Bounds of a figure whose error has none."""
    at_most: float
    elastic: float
    """The figure by Hertz's theory."""
    place: dict[str, Any] | None
    at: dict[str, Any] | None
    """`pass`, `hardening` or `load`; None of the step as it ends."""
    text: str
    detail: bool
    """Whether it stands behind the figures that answer the job."""

    @classmethod
    def of(cls, data: dict[str, Any]) -> Row:
        """A row as the service sends it."""
        known: dict[str, Any] = {one.name: data.get(one.name) for one in fields(cls)}
        for name in ("value", "at_least", "at_most", "elastic"):
            known[name] = math.nan if known[name] is None else float(known[name])
        error = known["error"]
        word = error if isinstance(error, str) else ""
        known["error"] = _WORDS[word] if word else float(error)
        known["reason"] = known["reason"] or word
        return cls(**known)

    @property
    def column(self) -> str:
        """Its column in tables: `lower_dent_depth`, `strain_per_pass_kinematic`."""
        body = f"{self.body}_" if self.body in ("upper", "lower") else ""
        rule = (self.at or {}).get("hardening")
        return f"{body}{self.name}{f'_{rule}' if rule else ''}"


class Figures:
    """Figures by name: `figures["peak_pressure"]`, `"dent_depth" in figures`."""

    @property
    def answers(self) -> list[Row]:
        """The rows: those that answer the job, in the order in which it asks for them, then
        details.
        """
        raise NotImplementedError

    @property
    def rows(self) -> pd.DataFrame:
        """All figures as a table, a line each, by name."""
        pandas = need("pandas", "pandas")
        frame: pd.DataFrame = pandas.DataFrame([asdict(row) for row in self.answers])
        return frame.set_index("name") if len(frame) else frame

    def row(self, name: str, body: str | None = None) -> Row:
        """The first row of a name: of several bodies that which decides, unless `body` says.

        Raises:
            KeyError: there is none.
        """
        answers = self.answers
        for row in answers:
            if row.name == name and body in (None, row.body):
                return row
        known = ", ".join(dict.fromkeys(row.name for row in answers))
        of = f" of the {body} body" if body else ""
        raise KeyError(f"no figure is called {name!r}{of}; there are {known}")

    def __getitem__(self, name: str) -> float:
        return self.row(name).value

    def __contains__(self, name: object) -> bool:
        return any(row.name == name for row in self.answers)

    def get(self, *names: str) -> float:
        """The first of these figures that is known; NaN without one."""
        known = (self[name] for name in names if name in self)
        return next((value for value in known if not math.isnan(value)), math.nan)


def line_of(rows: Iterable[Row]) -> dict[str, float]:
    """Figures and errors (`peak_pressure_error` and so on, relative) as a line of a table, and
    Hertz's where there are any (`peak_pressure_elastic`).
    """
    line: dict[str, float] = {}
    for row in rows:
        line.setdefault(row.column, row.value)
        line.setdefault(f"{row.column}_error", row.error)
        if not math.isnan(row.elastic):
            line.setdefault(f"{row.column}_elastic", row.elastic)
    return line
