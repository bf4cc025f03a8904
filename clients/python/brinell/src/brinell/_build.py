"""The parts of the builders: bodies, materials, jobs."""

from __future__ import annotations

import reprlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Literal, TypeAlias, TypeVar

from pydantic import BaseModel, ValidationError

from . import models
from ._errors import Fault, InvalidJob
from ._plain import Number, Quantity, named, not_finite, plain

__all__ = ["Material", "Number", "Quantity", "Support", "job", "material", "rigid"]

Material: TypeAlias = models.Deformable | models.Rigid | Mapping[str, Any] | str
"""A name among `materials`, a `material(...)`, `rigid`, or a dict as the service takes it."""

Support: TypeAlias = Literal["clamped", "roller"]
Analysis: TypeAlias = Literal["plane_strain", "plane_stress", "axisymmetric", "three_dimensional"]
M = TypeVar("M", bound=BaseModel)

rigid = models.Rigid(rigid=True)
"""A body that neither bends nor flows; one of the two has to deform."""


def checked(
    model: type[M],
    values: Mapping[str, Any],
    document: Mapping[str, Any] | None = None,
    at: str = "#",
) -> M:
    """Returns the model with these values, or raises all faults in them.

    `at` is the pointer of the model itself.
    """
    figures = plain(values, document or {})
    holes = not_finite(figures, at)
    if holes:
        raise InvalidJob(holes, f"not a valid {model.__name__}")
    try:
        return model.model_validate(figures)
    except ValidationError as error:
        faults = [_fault(at, one) for one in _chosen(error.errors())]
        raise InvalidJob(faults, f"not a valid {model.__name__}") from None


def _chosen(errors: list[Any]) -> list[Any]:
    """Keeps the errors of the branches of unions that `law` and `type` choose."""
    others = {
        one["loc"][:-1]
        for one in errors
        if one["type"] == "literal_error" and one["loc"][-1:] in (("law",), ("type",))
    }
    kept = [e for e in errors if not any(e["loc"][: len(other)] == other for other in others)]
    return kept or errors


def _fault(at: str, error: Any) -> Fault:
    # Pydantic names the branch of a union by its class or by the word that chose it; a pointer
    # has no such step.
    path: list[str] = []
    before = ""
    for step in map(str, error["loc"]):
        if not (hasattr(models, step) or before in ("shape", "plasticity")):
            path.append(f"/{step}")
        before = step
    given = error["input"]
    said = f", got {reprlib.repr(given)}" if isinstance(given, (int, float, str, list)) else ""
    what = (
        "missing"
        if error["type"] == "missing"
        else error["msg"][:1].lower() + error["msg"][1:] + said
    )
    return Fault(at + "".join(path), error["type"], what)


def build_body(
    model: type[M], material: Material, support: Support | None, /, **shape: Any
) -> models.ContactBody:
    """A body of this shape."""
    kind = str(model.model_fields["type"].annotation.__args__[0])  # type: ignore[union-attr]
    outline = checked(model, {"type": kind, **shape})
    if isinstance(material, str):
        material = named(material, "#/material")
    elif isinstance(material, Mapping):
        material = checked(models.Deformable, material, at="#/material")
    body = {"shape": outline, "material": material, "support": support}
    return checked(models.ContactBody, body)


def build_law(model: type[M], /, **values: Any) -> M:
    """A hardening law."""
    law = model.model_fields["law"].annotation.__args__[0]  # type: ignore[union-attr]
    return checked(model, {"law": str(law), **values})


def material(
    *,
    young_modulus: Number,
    poisson_ratio: float,
    plasticity: BaseModel | Mapping[str, Any] | None = None,
    initial_stress: Sequence[Mapping[str, Any]] | None = None,
    fatigue: Mapping[str, Any] | None = None,
) -> models.Deformable:
    """An isotropic material, elastic unless it has a hardening law.

    Args:
        young_modulus: Young's modulus E [MPa].
        poisson_ratio: Poisson's ratio.
        plasticity: a hardening law: `bilinear(...)`, `swift(...)` and so on.
        initial_stress: stress before any load, by depth: `{"depth": 0, "sigma_x": -500,
            "sigma_z": -500}` and so on.
        fatigue: limits of high-cycle fatigue [MPa]: `{"torsion": 480, "bending": 800}`, or
            `{"from_hardness": True}`.
    """
    values = {
        "young_modulus": young_modulus,
        "poisson_ratio": poisson_ratio,
        "plasticity": plasticity,
        "initial_stress": initial_stress,
        "fatigue": fatigue,
    }
    return checked(models.Deformable, values)


def job(
    upper: models.ContactBody | Mapping[str, Any],
    lower: models.ContactBody | Mapping[str, Any],
    *,
    analysis: Analysis,
    force: Number | None = None,
    forces: Iterable[Number] | Quantity | None = None,
    approach: Number | None = None,
    approaches: Iterable[Number] | Quantity | None = None,
    history: Sequence[Mapping[str, Any]] | None = None,
    onset: bool = False,
    target: Mapping[str, Any] | None = None,
    rolling: Mapping[str, Any] | None = None,
    theory: Literal["deformation", "flow"] | None = None,
    elements_per_half_width: int | None = None,
    fields: bool | None = None,
    contact_stiffness: bool | None = None,
    tags: Mapping[str, str] | None = None,
    solver: Mapping[str, Any] | None = None,
) -> models.ContactJob:
    """Makes a job: two bodies and the load that presses them together, in mm, N and MPa.

    Args:
        upper: the body above the contact: `cylinder(...)`, `block(...)` and so on.
        lower: the body below it.
        analysis: "plane_strain" for long bodies, "plane_stress" for thin discs,
            "axisymmetric" for bodies of revolution
            (a cylinder is a sphere there), "three_dimensional" for `sphere`, `curved` and `flat`.
        force: the force [N/mm of thickness; N in axisymmetry and three dimensions].
        forces: several of them, a step each.
        approach: how far the supports approach each other [mm]; the force is an output.
        approaches: several of them, a step each.
        history: loads one after the other, `{"force": F}` or `{"approach": a}`; 0 takes the
            load away.
        onset: ask for the force at which the contact begins to yield.
        target: ask for the force under which a figure has a value: `{"peak_pressure": 1200}`.
        rolling: a force that rolls over its track: `{"force": 2000, "friction": 0.2}`.
        theory: "flow" (default) follows the load from rest in increments; "deformation" takes
            it at once, knows no unloading, and its error has no bound.
        elements_per_half_width: how fine the mesh is (default 20).
        fields: whether the result has mesh and stresses of both bodies, for `result.fields()`.
        contact_stiffness: whether bodies that yield have a contact stiffness too, from two more
            solves of each step.
        tags: labels, echoed in the result.
        solver: further settings of the solver, as the service takes them.
    """
    loads: dict[str, Any] = {
        "force": force,
        "forces": _listed(forces),
        "approach": approach,
        "approaches": _listed(approaches),
        "history": history,
        "onset": onset or None,
        "target": target,
        "rolling": rolling,
    }
    given = [name for name, value in loads.items() if value is not None]
    if len(given) != 1:
        every = ", ".join(loads)
        raise InvalidJob(
            [
                Fault(
                    "#/load",
                    "one_of",
                    f"exactly one of {every}, got {' and '.join(given) or 'none'}; brinell_test,"
                    " vickers and rockwell_c make jobs of hardness tests",
                )
            ]
        )
    load = _load(given[0], loads[given[0]], {"analysis": analysis})
    settings = {**(solver or {}), **({"theory": theory} if theory else {})}
    document: dict[str, Any] = {
        "analysis": analysis,
        "upper": upper,
        "lower": lower,
        "load": load,
        "mesh": {"elements_per_half_width": elements_per_half_width}
        if elements_per_half_width is not None
        else None,
        "solver": settings or None,
        "output": {
            key: wanted
            for key, wanted in (("fields", fields), ("contact_stiffness", contact_stiffness))
            if wanted is not None
        }
        or None,
        "tags": tags,
    }
    return checked(models.ContactJob, document, document)


_LOADS: dict[str, type[BaseModel]] = {
    "force": models.ForceLoad,
    "forces": models.ForcesLoad,
    "approach": models.ApproachLoad,
    "rolling": models.RollingLoad,
    "approaches": models.ApproachesLoad,
    "history": models.HistoryLoad,
    "onset": models.OnsetLoad,
    "target": models.TargetLoad,
}


_TARGETS: dict[str, type[BaseModel]] = {
    "permanent_approach": models.PermanentApproachTarget,
    "dent_depth": models.DentDepthTarget,
    "half_width": models.HalfWidthTarget,
    "peak_pressure": models.PeakPressureTarget,
    "mean_pressure": models.MeanPressureTarget,
    "max_plastic_strain": models.MaxPlasticStrainTarget,
}
_PRESCRIBED: dict[str, type[BaseModel]] = {
    "force": models.PrescribedForce,
    "approach": models.PrescribedApproach,
}


def _load(name: str, value: Any, document: Mapping[str, Any]) -> BaseModel:
    if name == "target":
        value = _one_of(_TARGETS, value, document, "#/load/target")
    if name == "history" and isinstance(value, Sequence):
        value = [
            _one_of(_PRESCRIBED, one, document, f"#/load/history/{place}")
            for place, one in enumerate(value)
        ]
    return checked(_LOADS[name], {name: value}, document, "#/load")


def _one_of(
    kinds: Mapping[str, type[BaseModel]], value: Any, document: Mapping[str, Any], at: str
) -> BaseModel:
    """Returns the model that the single key of a dict names."""
    keys = list(value) if isinstance(value, Mapping) else []
    if len(keys) != 1 or keys[0] not in kinds:
        what = f"a dict with one of {', '.join(kinds)}, got {value!r}"
        raise InvalidJob([Fault(at, "one_of", what)])
    return checked(kinds[keys[0]], value, document, at)


def _listed(values: Any) -> Any:
    return list(values) if isinstance(values, (range, Iterator)) else values
