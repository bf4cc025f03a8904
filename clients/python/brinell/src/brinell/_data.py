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
from ._fatigue import Fatigue
from ._fields import Fields
from ._found import found_of, tolerances_of
from ._plain import need
from ._rows import Row, line_of
from ._step import Parts, Remark, Step

if TYPE_CHECKING:
    import pandas as pd

    from . import reports

NO_HARDNESS = 'this result is of no hardness test: load={"hardness": "HBW 10/3000"}'


class ResultData(Parts):
    """A result without its pictures and its words, which are made of it."""

    def __init__(
        self,
        report: dict[str, Any] | None,
        id: str = "",
        fetch: Callable[[str, int], bytes] | None = None,
        error: BrinellError | None = None,
    ) -> None:
        if report is not None and "answers" not in report:
            version = report.get("version", "an older one")
            error = BrinellError(f"solved by version {version}, read no longer: solve it again")
            report = None
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
        return [Step(step, place) for place, step in enumerate(self.data["steps"], 1)]

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
    def _step(self) -> dict[str, Any]:
        return self.last.data

    @cached_property
    def answers(self) -> list[Row]:
        """The rows that follow from more than one load, then those of the last step."""
        return [*map(Row.of, self.data["answers"]), *self.last.answers]

    @property
    def fatigue(self) -> Fatigue | None:
        """Whether the bodies endure; None without limits of fatigue."""
        return self.last.fatigue

    @property
    def remarks(self) -> list[Remark]:
        """What to keep in mind about this answer, of all steps, each once."""
        beside = [Remark(note["code"], note["message"]) for note in self.data.get("validity", [])]
        all_of_them = [*beside, *(remark for step in self.steps for remark in step.remarks)]
        return list(dict.fromkeys(all_of_them))

    @property
    def line(self) -> dict[str, Any]:
        """Status, figures and remarks as the line of a table."""
        if self._report is None or not self.steps:
            return {"status": self.status, "remarks": ""}
        codes = dict.fromkeys(remark.code for remark in self.remarks)
        return {"status": self.status, **line_of(self.answers), "remarks": " ".join(codes)}

    @property
    def summary(self) -> pd.DataFrame:
        """A line of figures for each step, numbered from 1."""
        pandas = need("pandas", "pandas")
        lines = [{"status": step.status, **line_of(step.answers)} for step in self.steps]
        frame: pd.DataFrame = pandas.DataFrame(lines)
        frame.index = pandas.RangeIndex(1, len(frame) + 1, name="step")
        frame.attrs["units"] = self.units
        return frame

    @property
    def load_approach(self) -> pd.DataFrame:
        """Force over approach, along all steps and the increments between them."""
        pandas = need("pandas", "pandas")
        curve = self.data.get("load_approach") or {
            "approach": [step.approach for step in self.steps],
            "force": [step.get("force") for step in self.steps],
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
        if "hardness" not in self:
            raise BrinellError(NO_HARDNESS)
        pandas = need("pandas", "pandas")
        rows = [(1, 0.0, 0.0, 0.0)]
        for number, step in enumerate(self.steps, start=1):
            ends = step.data["increments"]
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
