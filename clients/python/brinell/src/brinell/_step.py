"""One load of a result: its figures, tables and arrays."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._fields import Array
from ._plain import need
from ._rolling import Rolling

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

NAN = math.nan


class Remark(NamedTuple):
    """A remark on the validity of an answer."""

    code: str
    message: str


class Verdict(NamedTuple):
    """The state of the bodies: `level` for programs, `text` for a person. Both are empty of
    results of 0.2.
    """

    level: str
    text: str


@dataclass(frozen=True)
class Answer:
    """A figure as the service answers it. Unknown numbers are NaN."""

    name: str
    label: str
    body: str | None
    """`upper`, `lower`, `both`; None of the contact."""
    value: float
    quantity: str
    """`length`, `stress`, `force`; `strain` and `ratio` are shown in per cent."""
    unit: str
    error: float
    """Bound of the relative error of the mesh; 0 where the figure is prescribed."""
    elastic: float
    """The figure by Hertz's theory."""
    place: dict[str, Any] | None
    text: str

    @classmethod
    def of(cls, data: dict[str, Any]) -> Answer:
        """An answer as the service sends it."""
        return cls(
            name=data["name"],
            label=data["label"],
            body=data.get("body"),
            value=number(data.get("value")),
            quantity=data["quantity"],
            unit=data["unit"],
            error=number(data.get("error")),
            elastic=number(data.get("elastic")),
            place=data.get("place"),
            text=data["text"],
        )


@dataclass(frozen=True)
class Pressure:
    """Values at the pairs of nodes of a contact: over x, in axisymmetry over the radius."""

    x: Array
    pressure: Array
    force: Array
    gap: Array
    units: str

    def __repr__(self) -> str:
        return f"<pressure at {len(self.x)} pairs of nodes: x, pressure, force, gap>"

    def to_xarray(self) -> xr.Dataset:
        """As a dataset over x."""
        xarray = need("xarray", "pandas")
        names = ("pressure", "force", "gap")
        dataset: xr.Dataset = xarray.Dataset(
            {name: ("x", getattr(self, name)) for name in names},
            coords={"x": self.x},
            attrs={"units": self.units},
        )
        return dataset

    def to_frame(self) -> pd.DataFrame:
        """As a table."""
        pandas = need("pandas", "pandas")
        frame: pd.DataFrame = pandas.DataFrame(
            {"x": self.x, "pressure": self.pressure, "force": self.force, "gap": self.gap}
        )
        return frame


def number(value: Any) -> float:
    """A figure; NaN where there is none."""
    return NAN if value is None else float(value)


class Step:
    """One load. Unknown figures are NaN."""

    def __init__(self, data: dict[str, Any], place: int, units: str) -> None:
        self.data = data
        """The step as the service sends it."""
        self.place = place
        """Its number, from 1."""
        self.units = units

    @property
    def status(self) -> str:
        """`converged`, `not_converged`, `cancelled` or `timed_out`."""
        return str(self.data["status"])

    @property
    def converged(self) -> bool:
        """Whether the solution passes every check."""
        return self.status == "converged"

    @property
    def verdict(self) -> Verdict:
        """The state of the bodies in one sentence."""
        verdict = self.data.get("verdict") or {}
        return Verdict(verdict.get("level", ""), verdict.get("text", ""))

    @property
    def answers(self) -> list[Answer]:
        """The figures that answer the job, in the order in which it asks for them."""
        return [Answer.of(answer) for answer in self.data.get("answers") or []]

    @property
    def force(self) -> float:
        """The contact force."""
        return number(self.data["contact"]["force"])

    @property
    def approach(self) -> float:
        """How far the supports have come together."""
        return number(self.data["approach"])

    @property
    def peak_pressure(self) -> float:
        """The largest contact pressure."""
        return number(self.data["contact"]["peak_pressure"])

    @property
    def mean_pressure(self) -> float:
        """The force over the contact."""
        return number(self.data["contact"]["mean_pressure"])

    @property
    def half_width(self) -> float:
        """Half the width of the contact; its radius in axisymmetry."""
        return number(self.data["contact"]["half_width"])

    @property
    def contact_stiffness(self) -> float:
        """The slope of force over approach, NaN where bodies yield, unless asked for."""
        return number(self.data.get("contact_stiffness"))

    @property
    def max_plastic_strain(self) -> float:
        """The largest equivalent plastic strain of both bodies; NaN where it has no limit.

        That is so of a material that does not harden.
        """
        if self.rolling is not None:
            last = self.rolling.data["passes"][-1:]
            bodies = [body for one in last for body in one["bodies"].values() if body]
            return max((body["accumulated_strain"] for body in bodies), default=0.0)
        zones = [zone for zone in (self.data.get("plasticity") or {}).values() if zone]
        strains = [number(zone["max_equivalent_plastic_strain"]) for zone in zones]
        return NAN if any(map(math.isnan, strains)) else max(strains, default=NAN)

    @property
    def dent_depth(self) -> float:
        """Depth of the deeper of both dents (theory `flow`).

        NaN under a load: `surface` has the surfaces then.
        """
        surfaces = (self.data.get("flow") or {}).get("surfaces", {}).values()
        if not self.unloaded:
            return NAN
        return max((number(surface["depth"]) for surface in surfaces if surface), default=NAN)

    @property
    def unloaded(self) -> bool:
        """Whether the load is gone, so that what is left stays."""
        return self.force == 0.0

    @property
    def peak_position(self) -> float:
        """Where the pressure is largest, or was before the load went; profiles over depth lie
        there: x, in axisymmetry the radius.
        """
        return number(self.data["contact"]["peak_position"])

    @property
    def hertz(self) -> dict[str, Any]:
        """The elastic contact under the same force, where there is a closed form; else empty."""
        return self.data.get("hertz") or {}

    @property
    def relative_error(self) -> dict[str, float]:
        """Bounds of the relative discretization errors by figure, where there are any; those of
        a body as `upper.depth`.
        """
        errors = dict(self.data.get("estimated_error") or {})
        bodies = errors.pop("bodies", None) or {}
        for side, body in bodies.items():
            errors.update({f"{side}.{name}": value for name, value in (body or {}).items()})
        return {name: float(value) for name, value in errors.items() if value is not None}

    @property
    def rolling(self) -> Rolling | None:
        """The passes of a load that rolls; None of all other loads."""
        data = self.data.get("rolling")
        return Rolling(data) if data else None

    @property
    def remarks(self) -> list[Remark]:
        """What to keep in mind about this answer."""
        return [Remark(note["code"], note["message"]) for note in self.data.get("validity", [])]

    @property
    def pressure(self) -> Pressure:
        """Pressure, nodal force and gap over x, as arrays."""
        nodes = self.data["contact"]["nodes"]
        x, pressure, force, gap = (
            np.asarray(nodes[name], float) for name in ("x", "pressure", "force", "gap")
        )
        return Pressure(x, pressure, force, gap, self.units)

    @property
    def subsurface(self) -> pd.DataFrame:
        """Stresses over the depth below the middle of the contact, of both bodies (`body`); of a
        load that rolls what its last pass has left.

        Column `x` says where that is: x, in axisymmetry the radius.
        """
        return self._over_depth("subsurface")

    @property
    def subsurface_below_peak(self) -> pd.DataFrame:
        """The same below the peak pressure; empty where that is in the middle."""
        return self._over_depth("subsurface_below_peak")

    def _over_depth(self, member: str) -> pd.DataFrame:
        pandas = need("pandas", "pandas")
        frames = []
        for name, profile in (self.data.get(member) or {}).items():
            if profile:
                columns = {key: values for key, values in profile.items() if key != "position"}
                frames.append(
                    pandas.DataFrame({"body": name, **columns, "x": self.place_of(profile)})
                )
        table: pd.DataFrame = (
            pandas.concat(frames, ignore_index=True) if frames else pandas.DataFrame({"body": []})
        )
        return table

    def place_of(self, profile: dict[str, Any]) -> float:
        """The x of a profile over depth; profiles of 0.2 lie below the peak pressure."""
        return number(profile.get("position", self.peak_position))

    @property
    def surface(self) -> pd.DataFrame:
        """Height of both surfaces over x (theory `flow`); a dent is negative."""
        pandas = need("pandas", "pandas")
        surfaces = (self.data.get("flow") or {}).get("surfaces", {})
        frames = [
            pandas.DataFrame({"body": name, "x": surface["x"], "height": surface["height"]})
            for name, surface in surfaces.items()
            if surface
        ]
        frame: pd.DataFrame = (
            pandas.concat(frames, ignore_index=True) if frames else pandas.DataFrame({"body": []})
        )
        return frame

    def figures(self) -> dict[str, Any]:
        """The figures in one row: those of `FIGURES`, Hertz's, and error bars
        (`peak_pressure_error` and so on, relative).
        """
        row: dict[str, Any] = {
            "status": self.status,
            **{name: getattr(self, name) for name in FIGURES},
        }
        row["hertz_peak_pressure"] = number(self.hertz.get("peak_pressure"))
        row["hertz_half_width"] = number(self.hertz.get("half_width"))
        for name in ("peak_pressure", "half_width", "approach", "force"):
            row[f"{name}_error"] = self.relative_error.get(name, NAN)
        row["remarks"] = " ".join(remark.code for remark in self.remarks)
        return row

    def __repr__(self) -> str:
        figures = f"force {self.force:.5g}, peak pressure {self.peak_pressure:.5g}"
        return f"<step {self.place}: {self.status}, {figures}>"


FIGURES = (
    "force",
    "approach",
    "half_width",
    "peak_pressure",
    "mean_pressure",
    "contact_stiffness",
    "max_plastic_strain",
    "dent_depth",
)
NO_FIGURES: dict[str, Any] = {
    **dict.fromkeys((*FIGURES, "hertz_peak_pressure", "hertz_half_width"), NAN),
    **dict.fromkeys(
        ("peak_pressure_error", "half_width_error", "approach_error", "force_error"), NAN
    ),
    "remarks": "",
}
