"""The answer to a job: its figures, tables, arrays and pictures."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._errors import BrinellError, ServiceError
from ._fields import Array, Fields
from ._html import html_of, text_of
from ._plain import need
from ._rolling import Rolling

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

    from . import models
    from ._plot import Plot

NAN = math.nan
NO_HARDNESS = 'this result is of no hardness test: load={"hardness": "HBW 10/3000"}'


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
    bias: float
    """Relative difference to flow theory; NaN where it is not known."""
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
            bias=number(data.get("bias")),
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


class Result:
    """The answer to a job. Figures are those of its last step; `steps` has all of them.

    A job of `Client.map` without a result also gives a `Result`: `error` says why, and its figures
    raise it.
    """

    def __init__(
        self,
        report: dict[str, Any] | None,
        id: str = "",
        fetch: Callable[[str, int], bytes] | None = None,
        error: BrinellError | None = None,
    ) -> None:
        self._report = report
        self._fetch = fetch
        self.id = id
        """The job's name at the service."""
        self.error = error
        """Why there is no result."""

    @property
    def data(self) -> dict[str, Any]:
        """The result as the service sends it, without fields."""
        if self._report is None:
            raise self.error or BrinellError("there is no result")
        return self._report

    @cached_property
    def report(self) -> models.Report:
        """The result with a type for everything."""
        from . import models

        return models.Report.model_validate(self.data)

    @cached_property
    def steps(self) -> list[Step]:
        """One for each load."""
        return [Step(step, place, self.units) for place, step in enumerate(self.data["steps"], 1)]

    def __len__(self) -> int:
        return len(self.steps)

    def __getitem__(self, place: int) -> Step:
        return self.steps[place]

    @property
    def last(self) -> Step:
        """The last step."""
        if not self.steps:
            raise BrinellError(f"job {self.id} was stopped before its first step: {self.status}")
        return self.steps[-1]

    @property
    def status(self) -> str:
        """`converged`, `not_converged`, `cancelled`, `timed_out`.

        `invalid` or `failed` where there is no result.
        """
        if self._report is None:
            return "invalid" if isinstance(self.error, ValueError) else "failed"
        return str(self._report["status"])

    @property
    def converged(self) -> bool:
        """Whether every step's solution passes every check."""
        return self.status == "converged"

    @property
    def units(self) -> str:
        """`mm_N_MPa` or `SI`."""
        return str(self.data["units"])

    @property
    def analysis(self) -> str:
        """`plane_strain`, `plane_stress` or `axisymmetric`."""
        return str(self.data["analysis"])

    @property
    def verdict(self) -> Verdict:
        """The state of the bodies in one sentence."""
        return self.last.verdict

    @property
    def answers(self) -> list[Answer]:
        """The figures that answer the job, in the order in which it asks for them."""
        return self.last.answers

    @property
    def force(self) -> float:
        """The contact force [N/mm of thickness; N in axisymmetry]."""
        return self.last.force

    @property
    def approach(self) -> float:
        """How far the supports have come together [mm]."""
        return self.last.approach

    @property
    def peak_pressure(self) -> float:
        """The largest contact pressure [MPa]."""
        return self.last.peak_pressure

    @property
    def mean_pressure(self) -> float:
        """The force over the contact [MPa]."""
        return self.last.mean_pressure

    @property
    def half_width(self) -> float:
        """Half the width of the contact; its radius in axisymmetry [mm]."""
        return self.last.half_width

    @property
    def contact_stiffness(self) -> float:
        """The slope of force over approach [N/mm²; N/mm in axisymmetry]; NaN where bodies yield,
        unless the job asked for it."""
        return self.last.contact_stiffness

    @property
    def max_plastic_strain(self) -> float:
        """The largest equivalent plastic strain of both bodies."""
        return self.last.max_plastic_strain

    @property
    def dent_depth(self) -> float:
        """Depth of the deeper dent [mm] (theory `flow`); NaN unless the load is gone."""
        return self.last.dent_depth

    @property
    def hertz(self) -> dict[str, Any]:
        """The elastic contact under the same force, where there is a closed form; else empty."""
        return self.last.hertz

    @property
    def relative_error(self) -> dict[str, float]:
        """Bounds of the relative discretization errors by figure."""
        return self.last.relative_error

    @property
    def remarks(self) -> list[Remark]:
        """What to keep in mind about this answer, of all steps, each once."""
        return list(dict.fromkeys(remark for step in self.steps for remark in step.remarks))

    @property
    def rolling(self) -> Rolling | None:
        """The passes of a load that rolls; None of all other loads."""
        return self.last.rolling

    @property
    def target(self) -> dict[str, Any]:
        """Of a job with a target: `force`, `wanted`, `reached`, `relative_error`; else empty."""
        return self.data.get("target") or {}

    @property
    def hardness(self) -> dict[str, Any]:
        """Of a hardness test: `number`, `number_error`, `bias` and what was measured; else
        empty.
        """
        return self.data.get("hardness") or {}

    @property
    def yield_onset(self) -> dict[str, Any]:
        """Of a job that asks for the onset of yield: `force`, `approach`, `peak_pressure`, where.

        Else empty.
        """
        return self.last.data.get("yield_onset") or {}

    @property
    def pressure(self) -> Pressure:
        """Pressure, nodal force and gap over x, as arrays."""
        return self.last.pressure

    @property
    def subsurface(self) -> pd.DataFrame:
        """Stresses over the depth below the middle of the contact, of both bodies."""
        return self.last.subsurface

    @property
    def subsurface_below_peak(self) -> pd.DataFrame:
        """The same below the peak pressure; empty where that is in the middle."""
        return self.last.subsurface_below_peak

    @property
    def surface(self) -> pd.DataFrame:
        """Height of both surfaces over x (theory `flow`)."""
        return self.last.surface

    @property
    def summary(self) -> pd.DataFrame:
        """A row of figures for each step, numbered from 1."""
        pandas = need("pandas", "pandas")
        frame: pd.DataFrame = pandas.DataFrame([step.figures() for step in self.steps])
        frame.index = pandas.RangeIndex(1, len(frame) + 1, name="step")
        frame.attrs["units"] = self.units
        return frame

    @property
    def load_approach(self) -> pd.DataFrame:
        """Force over approach, along all steps and the increments between them."""
        pandas = need("pandas", "pandas")
        curve = self.data.get("load_approach") or {
            "approach": [step.approach for step in self.steps],
            "force": [step.force for step in self.steps],
        }
        frame: pd.DataFrame = pandas.DataFrame(curve)
        return frame

    @property
    def hardness_curve(self) -> pd.DataFrame:
        """Load-displacement curve of a hardness test, from rest on, as in `hardness.csv`.

        A row for each increment: `step`, `displacement`, `force`, `diameter` of the contact, and
        `mean_pressure`, which is nan without contact.
        """
        if not self.hardness:
            raise BrinellError(NO_HARDNESS)
        pandas = need("pandas", "pandas")
        rows = [(1, 0.0, 0.0, 0.0)]
        for number, step in enumerate(self.steps, start=1):
            ends = step.data["flow"]["increments"]
            columns = (ends["approach"], ends["force"], ends["half_width"])
            rows += [(number, h, f, 2 * a) for h, f, a in zip(*columns, strict=True)]
        frame: pd.DataFrame = pandas.DataFrame(
            rows, columns=["step", "displacement", "force", "diameter"]
        )
        area = np.pi / 4 * frame["diameter"] ** 2
        frame["mean_pressure"] = frame["force"] / area.where(area > 0)
        frame.attrs["units"] = self.units
        return frame

    def fields(self, step: int = -1) -> Fields:
        """Mesh and stresses of a step, counted from 0 as in `steps`.

        The job has to ask for them: `fields=True`.
        """
        if self._fetch is None:
            raise BrinellError(
                "this result does not come from a service that could be asked for its fields"
            )
        try:
            data = self._fetch(self.id, self.steps[step].place)
        except ServiceError as error:
            if error.status == 409:
                raise BrinellError("the job did not ask for fields: fields=True") from None
            raise
        return Fields.of(data, bool(self.data["mesh"]["symmetric"]))

    @property
    def plot(self) -> Plot:
        """Pictures: `plot.pressure()`, `.depth()`, `.field()`, `.load_approach()`, `.dent()`,
        `.residual_stress()`, `.passes()`, `.shakedown_map()`, `.hardness()`.
        """
        from ._plot import Plot

        return Plot(self)

    def __getstate__(self) -> dict[str, Any]:
        # A copy in another process, or a later one, has no service to fetch from.
        return {**self.__dict__, "_fetch": None}

    def __repr__(self) -> str:
        return text_of(self)

    def _repr_html_(self) -> str:
        return html_of(self)
