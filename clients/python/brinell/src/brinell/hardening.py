"""Hardening curves and hardened cases from measurements.

curve = brinell.hardening.from_tensile("bluehill.csv", young_modulus=206000)
steel = brinell.material(young_modulus=206000, poisson_ratio=0.3, plasticity=curve.law)
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from . import models
from ._arrays import floats_of
from ._build import Number, checked
from ._errors import Fault, InvalidJob
from ._table import STEEL, read_table

if TYPE_CHECKING:
    from ._client import Client

__all__ = ["TestedCurve", "case", "from_tensile", "profile", "read_table"]

Limit = Number | Literal["core+50", "80%"]


class TestedCurve(models.TestedCurve):
    """A hardening curve from a test: `points`, `slope`, `remarks` and what else was found."""

    __test__ = False  # no test of pytest

    @property
    def law(self) -> models.Table:
        """The law `table` of a job."""
        return models.Table(law="table", points=self.points)  # type: ignore[arg-type]

    def __str__(self) -> str:
        return "\n".join(self.remarks)


def from_tensile(
    strain: Any,
    stress: Any = None,
    *,
    young_modulus: float | None = None,
    strain_unit: Literal["1", "percent", "microstrain"] = "1",
    measure: Literal["engineering", "true"] | None = None,
    section: float | None = None,
    gauge_length: float | None = None,
    offset: float | None = None,
    yield_at: Literal["offset", "departure"] = "offset",
    units: Literal["mm_N_MPa", "SI"] = "mm_N_MPa",
    client: Client | None = None,
) -> TestedCurve:
    """The hardening curve of a tensile test; negative strain and stress are compression.

    The first slope is fitted and stands beside Young's modulus in `remarks`. Toe, unloading and
    what lies beyond necking are left out, and noise is fitted by a curve that never falls.

    Args:
        strain: list, array or column, elastic part included, in the order of the record; or the
            name of a file of text as testing machines write it, in any units it names.
        stress: as many stresses [MPa (SI: Pa)]; none beside a file.
        young_modulus: that of the job, to compare the first slope with.
        strain_unit: "percent" for figures like 0.2 at yield.
        measure: "engineering" over first length and section, or "true"; what the file says, or
            "engineering", if left out.
        section: of the specimen [mm²], for files of force over travel that do not say it.
        gauge_length: of the specimen [mm], likewise.
        offset: plastic strain at yield; 1e-4 if left out, 0.002 is R_p0.2.
        yield_at: "departure" is where the record leaves its first line for good.
        units: those of stress and modulus.
        client: the service to ask; one is started for the call if left out.

    Raises:
        InvalidJob: missing figures, and records that give no curve; every fault is named.
    """
    if stress is None:
        factor = 1e6 if units == "SI" else 1.0
        record = read_table(
            strain,
            section=section,
            gauge_length=gauge_length,
            young_modulus=(young_modulus or 0.0) / factor or STEEL,
        )
        if record.measure not in ("engineering", "true"):
            detail = f"it is of {record.measure or 'hardness'}, no strain and stress from rest"
            raise InvalidJob([Fault("#/points", "invalid", detail)])
        measure = measure or record.measure
        strain, stress = zip(*((e, s * factor) for e, s in record.points), strict=True)
    columns = [floats_of(one, "#/points").ravel() for one in (strain, stress)]
    if len(columns[0]) != len(columns[1]):
        counts = f"{len(columns[0])} strains and {len(columns[1])} stresses"
        raise InvalidJob([Fault("#/points", "inconsistent", f"there are {counts}")])
    points = np.column_stack(columns)
    missing = np.argwhere(~np.isfinite(points))
    if len(missing):
        faults = [
            Fault(f"#/points/{k}/{axis}", "wrong_type", "is missing or no number")
            for k, axis in missing[:100]
        ]
        detail = f"{len(missing)} of {points.size} figures are missing: leave out their points"
        raise InvalidJob(faults, detail)
    for name, figure in (("young_modulus", young_modulus), ("offset", offset)):
        if figure is not None and not math.isfinite(figure):
            raise InvalidJob([Fault(f"#/{name}", "wrong_type", f"{figure} is no finite number")])
    test: dict[str, Any] = {
        "points": points.tolist(),
        "strain_unit": strain_unit,
        "measure": measure or "engineering",
        "yield_at": yield_at,
        "units": units,
    }
    if young_modulus is not None:
        test["young_modulus"] = young_modulus
    if offset is not None:
        test["offset"] = offset
    if client is not None:
        return TestedCurve.model_validate(client._hardening_curve(test))
    from ._client import Client

    with Client() as own:
        return TestedCurve.model_validate(own._hardening_curve(test))


def profile(depth: Any, hardness: Any, *, scale: Literal["HV", "HRC"] = "HV") -> dict[str, Any]:
    """Measured hardness over depth [mm (SI: m)], for `over_depth` of a law.

    HRC becomes HV by ISO 18265, table A.1, in the service.
    """
    columns = [floats_of(one, "#/profile").ravel() for one in (depth, hardness)]
    if len(columns[0]) != len(columns[1]):
        counts = f"{len(columns[0])} depths and {len(columns[1])} hardnesses"
        raise InvalidJob([Fault("#/profile", "inconsistent", f"there are {counts}")])
    points = np.column_stack(columns)
    missing = np.argwhere(~np.isfinite(points))
    if len(missing):
        faults = [
            Fault(f"#/profile/{k}/{axis}", "wrong_type", "is missing") for k, axis in missing
        ]
        raise InvalidJob(faults, "hardness over depth has gaps: leave out these points")
    values = {"profile": points.tolist(), "hardness_scale": scale}
    checked(models.HardnessProfile, values)
    return {"hardness": values}


def case(
    surface: float,
    core: float,
    depth: Number,
    *,
    limit: Limit = 550,
    scale: Literal["HV", "HRC"] = "HV",
    curve: Literal["error_function", "lang"] = "error_function",
) -> dict[str, Any]:
    """A hardened case as a drawing specifies it, for `over_depth` of a law.

    Args:
        surface: hardness of the surface.
        core: hardness of the core.
        depth: case depth [mm (SI: m)].
        limit: hardness at the case depth: 550 HV of carburized cases (ISO 18203) or another
            figure, "core+50" of nitrided ones, "80%" of the surface of induction-hardened ones.
        scale: "HRC" becomes HV by ISO 18265, table A.1; `limit` is a figure of that scale then.
        curve: "lang" is Lang's profile.
    """
    at_depth: float | None
    if limit == 550 and scale == "HRC":
        # The service has its own 550 HV.
        at_depth = None
    elif isinstance(limit, str):
        if scale != "HV":
            detail = f'"{limit}" is a rule of Vickers hardness: give `limit` as a figure of HRC'
            raise InvalidJob([Fault("#/limit", "inconsistent", detail)])
        rules = {"core+50": core + 50, "80%": 0.8 * surface}
        if limit not in rules:
            detail = f'must be a figure, "core+50" or "80%", got "{limit}"'
            raise InvalidJob([Fault("#/limit", "unknown_word", detail)])
        at_depth = rules[limit]
    else:
        at_depth = float(limit)  # type: ignore[arg-type]
        at_depth = None if math.isclose(at_depth, 550) else at_depth
    values: dict[str, Any] = {"surface": surface, "core": core, "case_depth": depth}
    values |= {"curve": curve, "hardness_scale": scale}
    if at_depth is not None:
        values["limit"] = at_depth
    return {"hardness": values}
