"""The answer to a job: its figures, tables and arrays."""

from __future__ import annotations

import copy
import json
import os
from collections.abc import Callable
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ._errors import BrinellError, ServiceError
from ._fields import Fields
from ._found import found_of, tolerances_of
from ._plain import need
from ._rolling import Rolling
from ._step import Answer, Pressure, Remark, Step, Verdict

if TYPE_CHECKING:
    import pandas as pd

    from . import reports

NO_HARDNESS = 'this result is of no hardness test: load={"hardness": "HBW 10/3000"}'


class ResultData:
    """A result without its pictures and its words, which are made of it."""

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

    def to_dict(self) -> dict[str, Any]:
        """The result as the service sends it, without fields: a copy."""
        return copy.deepcopy(self.data)

    def save(self, path: str | os.PathLike[str], *, fields: bool = False) -> None:
        """Writes the result as a JSON file, as `brinell solve -o` does; `Result.load` reads it.

        Args:
            path: the file.
            fields: whether mesh and stresses of each step are written too, as `.npz` beside it.
        """
        path = Path(path)
        path.write_text(json.dumps(self.data), "utf-8")
        for step in self.steps if fields else []:
            archive_of(path, step.place).write_bytes(self._archive(step.place))

    @cached_property
    def report(self) -> reports.Report:
        """The result with a type for everything."""
        from . import reports

        return reports.Report.model_validate(self.data)

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
    def found(self) -> pd.DataFrame:
        """The jobs of a search (`find`): `value`, `figure`, `error`; `attrs` has its answer."""
        return found_of(self.data)

    @property
    def tolerances(self) -> pd.DataFrame:
        """What tolerances of inputs do to each figure, a row for each."""
        return tolerances_of(self.data)

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
        return Fields.of(
            self._archive(self.steps[step].place), bool(self.data["mesh"]["symmetric"])
        )

    def _archive(self, place: int) -> bytes:
        if self._fetch is None:
            raise BrinellError(
                "this result does not come from a service that could be asked for its fields"
            )
        try:
            return self._fetch(self.id, place)
        except (ServiceError, LookupError, FileNotFoundError) as error:
            if isinstance(error, ServiceError) and error.status != 409:
                raise
            raise BrinellError("the job did not ask for fields: fields=True") from None

    def __getstate__(self) -> dict[str, Any]:
        # A copy in another process, or a later one, has no service to fetch from.
        return {**self.__dict__, "_fetch": None}


def archive_of(path: Path, place: int) -> Path:
    """The file of the fields of a step beside that of the result."""
    return path.with_name(f"{path.stem}.{place}.npz")
