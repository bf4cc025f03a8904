"""Jobs as plain JSON: from dicts, files and models, with figures from numpy and quantities from
pint.
"""

from __future__ import annotations

import base64
import copy
import io
import json
import math
import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, Protocol, TypeAlias, runtime_checkable

import numpy as np
from pydantic import BaseModel

from ._arrays import grid_of, without_mask
from ._errors import Fault, InvalidJob
from ._materials import materials
from .models import Deformable


@runtime_checkable
class Quantity(Protocol):
    """A figure with a unit, as pint and others have it: `quantity.to("mm").magnitude`."""

    def to(self, unit: Any, /) -> Any:
        """The same in another unit."""

    @property
    def magnitude(self) -> Any:
        """The figure alone."""


@runtime_checkable
class InJob(Protocol):
    """What stands in a job by figures of its own: a measured surface, a trace."""

    def in_job(self, unit: str, /) -> Any:
        """These figures, lengths in this unit."""


Number: TypeAlias = float | Quantity
"""A figure, in mm, N and MPa unless it is a quantity with a unit of its own."""

JobLike: TypeAlias = Mapping[str, Any] | BaseModel | str | os.PathLike[str]
"""A job: from `brinell.job(...)`, a dict as the service takes it, or the path of a JSON file."""

LENGTH, STRESS, FORCE, ANGLE, PURE = "length", "stress", "force", "degree", "dimensionless"
MOMENT = "moment"

# Quantity of the figures under a key. Pairs have a quantity for each of their two columns.
_KINDS: dict[str, str | tuple[str, str]] = {
    **dict.fromkeys(
        [
            "ball",
            "radius",
            "radius_x",
            "length",
            "crown_radius",
            "spacing_x",
            "spacing_y",
            "heights",
            "radius_y",
            "width",
            "depth",
            "outer_radius",
            "tip_radius",
            "edge_radius",
            "scale",
            "semi_axis_x",
            "semi_axis_y",
            "case_depth",
            "approach",
            "approaches",
            "permanent_approach",
            "dent_depth",
            "half_width",
        ],
        LENGTH,
    ),
    **dict.fromkeys(
        [
            "young_modulus",
            "indenter_young_modulus",
            "yield_stress",
            "tangent_modulus",
            "reference_stress",
            "coefficient",
            "saturation_stress",
            "modulus",
            "sigma_x",
            "sigma_z",
            "torsion",
            "bending",
            "mean_pressure",
            "peak_pressure",
        ],
        STRESS,
    ),
    "force": FORCE,
    "forces": FORCE,
    "design_force": FORCE,
    "moment": MOMENT,
    "angle": ANGLE,
    "rotation": ANGLE,
    "over_depth": (LENGTH, PURE),
    "profile": (LENGTH, PURE),
    "points": (LENGTH, LENGTH),
    "points of a law": (PURE, STRESS),
}


def is_length_of(name: str) -> bool:
    """Whether the figures of a member of a job are lengths."""
    return _KINDS.get(name) == LENGTH


def unit_of(kind: str, document: Mapping[str, Any]) -> str:
    """The unit of a kind of figure in this job."""
    si = document.get("units") == "SI"
    per_length = document.get("analysis") not in ("axisymmetric", "three_dimensional")
    return {
        LENGTH: "m" if si else "mm",
        STRESS: "Pa" if si else "MPa",
        FORCE: ("N/m" if si else "N/mm") if per_length else "N",
        MOMENT: "N*m" if si else "N*mm",
    }.get(kind, kind)


def plain(value: Any, document: Mapping[str, Any] | None = None, key: str = "") -> Any:
    """Converts a value to Python's lists, dicts and numbers; drops `None` from dicts.

    Quantities are given in the units of the document, by the key that they stand under.
    """
    document = document if document is not None else (value if isinstance(value, Mapping) else {})
    if isinstance(value, InJob):
        return plain(value.in_job(unit_of(LENGTH, document)), document, key)
    if isinstance(value, BaseModel):
        return value.model_dump(mode="json", exclude_none=True)
    if isinstance(value, Mapping):
        law = "law" in value
        return {
            str(k): plain(v, document, "points of a law" if law and k == "points" else str(k))
            for k, v in value.items()
            if v is not None
        }
    kind = _KINDS.get(key, PURE)
    if key == "heights" and not isinstance(value, (list, tuple)):
        return _heights(value, document)
    if (
        isinstance(kind, tuple)
        and isinstance(value, (list, tuple))
        and len(value) == 2
        and _is_pair(value)
    ):
        return [_figure(v, k, document) for v, k in zip(value, kind, strict=True)]
    if isinstance(value, (list, tuple)):
        return [plain(v, document, key) for v in value]
    return _figure(value, kind if isinstance(kind, str) else kind[0], document)


def _heights(value: Any, document: Mapping[str, Any]) -> Any:
    """An array of heights as `numpy.save` writes it; lists where it has holes, to name them."""
    if isinstance(value, Quantity):
        value = value.to(unit_of(LENGTH, document)).magnitude
    single = getattr(value, "dtype", None) == np.float32
    array = grid_of(value)
    if array.ndim != 2 or not np.isfinite(array).all():
        return array.tolist()
    file = io.BytesIO()
    np.save(file, np.ascontiguousarray(array, "<f4" if single else "<f8"), allow_pickle=False)
    return {"npy_base64": base64.b64encode(file.getvalue()).decode("ascii")}


def _is_pair(value: list[Any] | tuple[Any, ...]) -> bool:
    return not any(isinstance(v, (list, tuple, Mapping)) or getattr(v, "ndim", 0) for v in value)


def _figure(value: Any, kind: str, document: Mapping[str, Any]) -> Any:
    if isinstance(value, Quantity):
        value = value.to(unit_of(kind, document)).magnitude
    value = without_mask(value)
    return value.tolist() if hasattr(value, "tolist") else value


def document_of(job: JobLike) -> dict[str, Any]:
    """The job as a document of its own."""
    if isinstance(job, (str, os.PathLike)):
        job = json.loads(Path(job).read_text("utf-8-sig"))
    if not isinstance(job, (Mapping, BaseModel)):
        raise TypeError(
            f"a job is brinell.job(...), a dict or the path of a file, not {type(job).__name__}"
        )
    document = plain(job)
    assert isinstance(document, dict)
    faults = not_finite(document)
    if faults:
        raise InvalidJob(faults)
    return document


def not_finite(document: Any, at: str = "#") -> list[Fault]:
    """A fault for each list with figures that JSON cannot represent, at the first of them.

    Holes, masked and missing values are such figures. `at` is the pointer of the document.
    """
    found: dict[str, list[tuple[str, float]]] = {}
    counts: dict[str, int] = {}
    for pointer, figure in _figures(document, ""):
        of = re.sub(r"(/\d+)+$", "", pointer)
        counts[of] = counts.get(of, 0) + 1
        if not math.isfinite(figure):
            found.setdefault(of, []).append((pointer, figure))
    return [
        Fault(f"{at}{all_of_it[0][0]}", "not_finite", _missing(of, all_of_it, counts[of]))
        for of, all_of_it in found.items()
    ]


def _missing(of: str, found: list[tuple[str, float]], count: int) -> str:
    pointer, first = found[0]
    place = [int(step) for step in pointer[len(of) + 1 :].split("/") if step]
    if not of.endswith("heights"):
        more = f", and {len(found) - 1} more" if len(found) > 1 else ""
        said = f"{first} is not a finite number{more}"
        return said + (": a hole, a masked or a missing value" if math.isnan(first) else "")
    return (
        f"{grouped(len(found))} of {grouped(count)} heights {'are' if len(found) > 1 else 'is'} "
        f'missing, the first at {place}: brinell.surface(..., fill="harmonic") fills holes'
    )


def grouped(count: int) -> str:
    """A count with its digits in threes."""
    return f"{count:,}".replace(",", " ")


def _figures(value: Any, pointer: str) -> Iterator[tuple[str, float]]:
    """The figures of a document, with their pointers."""
    if isinstance(value, float):
        yield pointer, value
    elif isinstance(value, (dict, list)):
        items = value.items() if isinstance(value, dict) else enumerate(value)
        for key, one in items:
            yield from _figures(one, f"{pointer}/{key}")


def need(package: str, extra: str) -> Any:
    """A package that an extra brings."""
    import importlib

    try:
        return importlib.import_module(package)
    except ImportError as error:
        raise ImportError(f'this needs {package}: pip install "brinell[{extra}]"') from error


def named(material: str, pointer: str) -> Deformable:
    """A material of the library, by its name."""
    try:
        return materials[material]
    except KeyError as error:
        fault = Fault(pointer, "unknown_material", str(error.args[0]))
        raise InvalidJob([fault]) from None


def tokens_of(pointer: str) -> list[str]:
    """The steps of a JSON pointer, with or without `#`."""
    path = pointer.removeprefix("#")
    if not path.startswith("/"):
        raise ValueError(
            f'a pointer begins with "/" or "#/", as in "/load/force", not {pointer!r}'
        )
    return [step.replace("~1", "/").replace("~0", "~") for step in path[1:].split("/")]


def with_values(document: Mapping[str, Any], values: Mapping[str, Any]) -> dict[str, Any]:
    """A copy of the document with other values at these pointers.

    Objects on the way are made if they are missing. A material may be a name of the library.
    """
    made: dict[str, Any] = copy.deepcopy(dict(document))
    for pointer, value in values.items():
        *way, last = tokens_of(pointer)
        place: Any = made
        for step in way:
            if isinstance(place, list):
                place = place[int(step)]
            else:
                if place.get(step) is None:
                    place[step] = {}
                place = place[step]
        if last == "material" and isinstance(value, str):
            value = named(value, f"#{pointer.removeprefix('#')}")
        figure = plain(value, made, last if isinstance(place, dict) else way[-1])
        if isinstance(place, list):
            place[int(last)] = figure
        elif isinstance(place, dict):
            place[last] = figure
        else:
            raise ValueError(f"{pointer!r} leads through a figure")
    return made
