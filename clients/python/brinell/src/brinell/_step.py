"""One load of a result: its figures, tables and arrays."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._fields import Array
from ._plain import need
from ._rows import Figures, Row

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr


class Remark(NamedTuple):
    """A remark on the validity of an answer."""

    code: str
    message: str


class Verdict(NamedTuple):
    """The state of the bodies: `level` for programs, `text` for a person."""

    level: str
    text: str


@dataclass(frozen=True)
class Pressure:
    """Values at the pairs of nodes of a contact: over x, in axisymmetry over the radius."""

    x: Array
    pressure: Array
    force: Array
    gap: Array

    def __repr__(self) -> str:
        return f"<pressure at {len(self.x)} pairs of nodes: x, pressure, force, gap>"

    def to_xarray(self) -> xr.Dataset:
        """As a dataset over x."""
        need("xarray", "pandas")
        data: xr.Dataset = self.to_frame().set_index("x").to_xarray()
        return data

    def to_frame(self) -> pd.DataFrame:
        """As a table."""
        columns = ("x", "pressure", "force", "gap")
        pandas = need("pandas", "pandas")
        frame: pd.DataFrame = pandas.DataFrame({name: getattr(self, name) for name in columns})
        return frame


class Parts(Figures):
    """Sentence, figures and arrays of a load."""

    @property
    def _step(self) -> dict[str, Any]:
        """The step as the service sends it."""
        raise NotImplementedError

    @property
    def verdict(self) -> Verdict:
        """The state of the bodies in one sentence."""
        return Verdict(self._step["verdict"]["level"], self._step["verdict"]["text"])

    @property
    def approach(self) -> float:
        """How far the bodies have approached; without force under flow theory for good."""
        return self.get("approach", "permanent_approach")

    @property
    def half_width(self) -> float:
        """Half the width of the contact, its radius, or the shorter semi-axis."""
        return self.get("half_width", "semi_axis_a")

    @property
    def unloaded(self) -> bool:
        """Whether the load is gone, so that what is left stays."""
        return self.get("force") == 0.0

    @property
    def pressure(self) -> Pressure:
        """Pressure, nodal force and gap over x, as arrays."""
        nodes = self._step["contact"]["nodes"]
        x, pressure, force, gap = (
            np.asarray(nodes[name], float) for name in ("x", "pressure", "force", "gap")
        )
        return Pressure(x, pressure, force, gap)

    @property
    def subsurface(self) -> pd.DataFrame:
        """Stresses over the depth below the middle of the contact, of both bodies (`body`); of a
        load that rolls what its last pass has left.

        Column `x` says where that is: x, in axisymmetry the radius.
        """
        return self._of_bodies("subsurface")

    @property
    def subsurface_below_peak(self) -> pd.DataFrame:
        """The same below the peak pressure; empty where that is in the middle."""
        return self._of_bodies("subsurface_below_peak")

    @property
    def surface(self) -> pd.DataFrame:
        """Height of both surfaces over x (theory `flow`); a dent is negative."""
        return self._of_bodies("surfaces")

    def _of_bodies(self, member: str) -> pd.DataFrame:
        """The columns of both bodies, one below the other."""
        pandas = need("pandas", "pandas")
        frames = []
        for body, values in (self._step.get(member) or {}).items():
            if values:
                columns = {key: one for key, one in values.items() if key != "position"}
                places = dict(zip("xy", values.get("position", []), strict=False))
                frames.append(pandas.DataFrame({"body": body, **columns, **places}))
        empty = pandas.DataFrame({"body": []})
        table: pd.DataFrame = pandas.concat(frames, ignore_index=True) if frames else empty
        return table

    @property
    def passes(self) -> pd.DataFrame:
        """A line for each pass of a load that rolls, by its number; empty of other loads.

        Figures of a body are `lower_track_depth` and so on, relative errors end with `_error`.
        """
        pandas = need("pandas", "pandas")
        passes = self._step.get("passes") or {"number": []}
        columns: dict[str, Any] = {}
        for prefix, part in (("", "contact"), ("upper_", "upper"), ("lower_", "lower")):
            for name, course in passes.get(part, {}).items():
                columns[f"{prefix}{name}"] = course["value"]
                columns[f"{prefix}{name}_error"] = np.asarray(course["error"], float)
        frame: pd.DataFrame = pandas.DataFrame(
            columns, index=pandas.Index(passes["number"], name="number")
        )
        return frame


class Step(Parts):
    """One load."""

    def __init__(self, data: dict[str, Any], place: int) -> None:
        self.data = data
        """The step as the service sends it."""
        self.place = place
        """Its number, from 1."""

    @property
    def _step(self) -> dict[str, Any]:
        return self.data

    @cached_property
    def answers(self) -> list[Row]:
        """The rows of the step."""
        return [Row.of(row) for row in self.data["answers"]]

    @property
    def status(self) -> str:
        """`converged`, `not_converged`, `cancelled` or `timed_out`."""
        return str(self.data["status"])

    @property
    def converged(self) -> bool:
        """Whether the solution passes every check."""
        return self.status == "converged"

    @property
    def remarks(self) -> list[Remark]:
        """What to keep in mind about this answer."""
        return [Remark(note["code"], note["message"]) for note in self.data["validity"]]

    def __repr__(self) -> str:
        figures = (f"{name} {self.get(name):.5g}" for name in ("force", "peak_pressure"))
        return f"<step {self.place}: {self.status}, {', '.join(figures)}>"
