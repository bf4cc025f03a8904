"""Jobs of hardness tests."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from . import models
from ._build import checked
from ._builders import block

Material = models.Deformable | Mapping[str, Any]


def brinell_test(
    material: Material,
    *,
    ball: float = 10.0,
    force_kgf: float = 3000.0,
    thickness: float | None = None,
    elements_per_half_width: int | None = None,
) -> models.ContactJob:
    """Makes a Brinell test: `result["hardness"]` is HBW.

    Args:
        material: of the specimen, with a hardening law.
        ball: diameter of the ball: 10, 5, 2.5 or 1 mm.
        force_kgf: the force [kgf]; ISO 6506 has 30, 15, 10, 5, 2.5 and 1 times the square of
            the ball.
        thickness: of the specimen [mm]; four balls unless given.
        elements_per_half_width: elements over the radius of the contact; 24 unless given.
    """
    test = {"scale": "HBW", "ball": ball, "force_kgf": force_kgf}
    thickness = 4 * ball if thickness is None else thickness
    return _job(test, material, 8 * ball, thickness, elements_per_half_width)


def vickers(
    material: Material,
    *,
    force_kgf: float = 1.0,
    thickness: float | None = None,
    elements_per_half_width: int | None = None,
) -> models.ContactJob:
    """Makes a Vickers test by the cone of equal area: `result["hardness"]` is HV.

    Args:
        material: of the specimen, with a hardening law.
        force_kgf: the force [kgf].
        thickness: of the specimen [mm]; 2 mm times the root of the force unless given.
        elements_per_half_width: elements over the radius of the contact; 24 unless given.
    """
    size = 2.0 * max(float(force_kgf), 0.0) ** 0.5
    test = {"scale": "HV", "force_kgf": force_kgf}
    thickness = size if thickness is None else thickness
    return _job(test, material, 2 * size, thickness, elements_per_half_width)


def rockwell_c(
    material: Material,
    *,
    thickness: float = 8.0,
    elements_per_half_width: int | None = None,
) -> models.ContactJob:
    """Makes a Rockwell C test: `result["hardness"]` is HRC.

    Args:
        material: of the specimen, with a hardening law.
        thickness: of the specimen [mm].
        elements_per_half_width: elements over the radius of the contact; 24 unless given.
    """
    return _job({"scale": "HRC"}, material, 16.0, thickness, elements_per_half_width)


def _job(
    test: dict[str, Any],
    material: Material,
    width: float,
    thickness: float,
    elements: int | None,
) -> models.ContactJob:
    document: dict[str, Any] = {
        "analysis": "axisymmetric",
        "lower": block(width=width, depth=thickness, material=material),
        "load": {"hardness": test},
        "mesh": {"elements_per_half_width": elements} if elements is not None else None,
    }
    return checked(models.ContactJob, document, document)
