# Generated from api/openapi.json by clients/python/scripts/builders.py; do not edit.
"""Bodies by their shape, and hardening laws."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ._build import Material, Number, Support, build_body, build_law
from .models import (
    Bilinear,
    Block,
    Cone,
    ContactBody,
    Curved,
    Cylinder,
    Ellipse,
    Flat,
    Groove,
    Hole,
    Ludwik,
    Parabola,
    Power,
    Profile,
    Punch,
    RambergOsgood,
    Roller,
    Sphere,
    Swift,
    Table,
    Voce,
    Wedge,
)

__all__ = [
    "bilinear",
    "block",
    "cone",
    "curved",
    "cylinder",
    "ellipse",
    "flat",
    "groove",
    "hole",
    "ludwik",
    "parabola",
    "power",
    "profile",
    "punch",
    "ramberg_osgood",
    "roller",
    "sphere",
    "swift",
    "table",
    "voce",
    "wedge",
]


def block(
    *,
    depth: Number,
    width: Number,
    material: Material,
    support: Support | None = None,
) -> ContactBody:
    """A rectangle, held at its base.

    Args:
        depth: Height of the rectangle below the contact.
        width: Full width, centred on the contact.
        material: a name among `materials`, `material(...)` or `rigid`.
        support: how its far boundary is held: "clamped" (default) or "roller".
    """
    return build_body(Block, material, support, depth=depth, width=width)


def cone(
    *,
    angle: Number,
    depth: Number,
    width: Number,
    material: Material,
    tip_radius: Number | None = None,
    support: Support | None = None,
) -> ContactBody:
    """A flank of revolution that ends in a tip; only in axisymmetry.

    Args:
        angle: Angle β of the flank to the tangential plane, in degrees. Without unit.
        depth: From the tip to the base, more than the height of the flank.
        width: Diameter of the base.
        tip_radius: Radius of the tip; sharp if it is left out.
        material: a name among `materials`, `material(...)` or `rigid`.
        support: how its far boundary is held: "clamped" (default) or "roller".
    """
    return build_body(Cone, material, support, angle=angle, depth=depth, width=width, tip_radius=tip_radius)


def curved(
    *,
    material: Material,
    radius_x: Number | None = None,
    radius_y: Number | None = None,
    rotation: Number | None = None,
    support: Support | None = None,
) -> ContactBody:
    """A half-space whose surface has a curvature along its x and one along its y: roller, raceway,
    crowned part; only in three dimensions.

    Args:
        radius_x: Radius of curvature along its x; negative is concave, left out is straight.
        radius_y: Radius of curvature along its y; negative is concave, left out is straight.
        rotation: Angle of its x from that of the contact plane, in degrees, towards y; 0 if it is
            left out. Without unit.
        material: a name among `materials`, `material(...)` or `rigid`.
        support: how its far boundary is held: "clamped" (default) or "roller".
    """
    return build_body(Curved, material, support, radius_x=radius_x, radius_y=radius_y, rotation=rotation)


def cylinder(
    *,
    radius: Number,
    material: Material,
    support: Support | None = None,
) -> ContactBody:
    """Half a cylinder, held at its diametral plane.

    Args:
        radius: Radius.
        material: a name among `materials`, `material(...)` or `rigid`.
        support: how its far boundary is held: "clamped" (default) or "roller".
    """
    return build_body(Cylinder, material, support, radius=radius)


def ellipse(
    *,
    semi_axis_x: Number,
    semi_axis_y: Number,
    material: Material,
    support: Support | None = None,
) -> ContactBody:
    """Half an ellipse, held at its axis along x.

    Args:
        semi_axis_x: Half its extent along x.
        semi_axis_y: Half its extent along y.
        material: a name among `materials`, `material(...)` or `rigid`.
        support: how its far boundary is held: "clamped" (default) or "roller".
    """
    return build_body(Ellipse, material, support, semi_axis_x=semi_axis_x, semi_axis_y=semi_axis_y)


def flat(
    *,
    material: Material,
    rotation: Number | None = None,
    support: Support | None = None,
) -> ContactBody:
    """A plane half-space; only in three dimensions.

    Args:
        rotation: Angle of the body about the normal, in degrees, from x towards y; 0 if it is left
            out. Without unit.
        material: a name among `materials`, `material(...)` or `rigid`.
        support: how its far boundary is held: "clamped" (default) or "roller".
    """
    return build_body(Flat, material, support, rotation=rotation)


def groove(
    *,
    depth: Number,
    radius: Number,
    width: Number,
    material: Material,
    support: Support | None = None,
) -> ContactBody:
    """A block with a concave circular trough across its whole upper face.

    Args:
        depth: From the bottom of the trough to the base.
        radius: Radius of the trough.
        width: Full width, at most twice the radius.
        material: a name among `materials`, `material(...)` or `rigid`.
        support: how its far boundary is held: "clamped" (default) or "roller".
    """
    return build_body(Groove, material, support, depth=depth, radius=radius, width=width)


def hole(
    *,
    radius: Number,
    material: Material,
    outer_radius: Number | None = None,
    width: Number | None = None,
    support: Support | None = None,
) -> ContactBody:
    """A round hole in the middle of a disc or of a square plate, which holds a `cylinder` with
    clearance; in axisymmetry the spherical socket of a ball.

    Args:
        radius: Radius of the hole, larger than that of the cylinder in it.
        outer_radius: Radius of the disc, larger than that of the hole.
        width: Width of the square plate, in place of `outer_radius`; only in plane analyses.
        material: a name among `materials`, `material(...)` or `rigid`.
        support: how its far boundary is held: "clamped" (default) or "roller".
    """
    return build_body(Hole, material, support, radius=radius, outer_radius=outer_radius, width=width)


def parabola(
    *,
    depth: Number,
    radius: Number,
    width: Number,
    material: Material,
    support: Support | None = None,
) -> ContactBody:
    """A block with the surface y = −x²/2R.

    Args:
        depth: From the vertex to the base, more than the fall of the surface at its ends.
        radius: Radius of curvature at the vertex.
        width: Full width.
        material: a name among `materials`, `material(...)` or `rigid`.
        support: how its far boundary is held: "clamped" (default) or "roller".
    """
    return build_body(Parabola, material, support, depth=depth, radius=radius, width=width)


def power(
    *,
    depth: Number,
    exponent: Number,
    scale: Number,
    width: Number,
    material: Material,
    support: Support | None = None,
) -> ContactBody:
    """A block with the surface y = −L (|x|/L)^n.

    Args:
        depth: From the vertex to the base, more than the fall of the surface at its ends.
        exponent: Exponent n; 2 is a parabola, a large one nearly a flat punch. Without unit.
        scale: Length L, the distance at which the surface has fallen by as much.
        width: Full width.
        material: a name among `materials`, `material(...)` or `rigid`.
        support: how its far boundary is held: "clamped" (default) or "roller".
    """
    return build_body(Power, material, support, depth=depth, exponent=exponent, scale=scale, width=width)


def profile(
    *,
    depth: Number,
    points: Sequence[tuple[Number, Number]] | Sequence[Sequence[Number]] | Any,
    material: Material,
    interpolation: str | None = None,
    support: Support | None = None,
) -> ContactBody:
    """A block whose upper face passes through points, smooth or straight between them.

    Args:
        depth: From height 0 to the base; every height is above it.
        points: Points `[x, height]`, x rising and passing 0. A face that starts or ends at x = 0 is
            completed by its mirror image.
        interpolation: What the face is like between its points: `smooth` to the first derivative,
            without overshoot, or `linear`, so that points are corners. If it is left out, the
            face is smooth, and refused where that would round off a corner in the contact.
        material: a name among `materials`, `material(...)` or `rigid`.
        support: how its far boundary is held: "clamped" (default) or "roller".
    """
    return build_body(Profile, material, support, depth=depth, points=points, interpolation=interpolation)


def punch(
    *,
    depth: Number,
    width: Number,
    material: Material,
    edge_radius: Number | None = None,
    support: Support | None = None,
) -> ContactBody:
    """A rigid flat punch with sharp or rounded edges.

    Args:
        depth: Height of the side walls, more than the edge radius.
        width: Full width with the edges, the diameter in axisymmetry.
        edge_radius: Radius of the edges, less than half the width; sharp if it is 0 or left out.
        material: a name among `materials`, `material(...)` or `rigid`.
        support: how its far boundary is held: "clamped" (default) or "roller".
    """
    return build_body(Punch, material, support, depth=depth, width=width, edge_radius=edge_radius)


def roller(
    *,
    length: Number,
    radius: Number,
    material: Material,
    crown_radius: Number | None = None,
    design_force: Number | None = None,
    moment: Number | None = None,
    points: Sequence[tuple[Number, Number]] | Sequence[Sequence[Number]] | Any = None,
    profile: str | None = None,
    rotation: Number | None = None,
    tilt: Number | None = None,
    support: Support | None = None,
) -> ContactBody:
    """A cylinder of finite length, whose axis is its y: a roller, a rib; only in three dimensions.

    Args:
        length: Length that can touch, without the rounded ends.
        radius: Radius.
        crown_radius: Radius of the arc along the axis, for `crowned`.
        design_force: Force under which a `logarithmic` profile makes the pressure along the roller
            even.
        moment: Moment about its x axis through the middle, in place of `tilt`, which is found then:
            positive presses the end at positive y. It is whole from the smallest force of the
            job on and in proportion to the force below. Only with forces.
        points: Points `[y, height]` for `points`, y rising and passing 0, straight between them.
            Points that start or end at y = 0 are completed by their mirror image. Beyond the
            outermost ones the height stays.
        profile: How the surface falls towards the ends: `crowned` in an arc of `crown_radius`,
            `logarithmic` by Lundberg for `design_force`, `iso_16281` with the factor of that
            standard, `points` as given. If it is left out, the roller is straight.
        rotation: Angle of its x from that of the contact plane, in degrees, towards y; 0 if it is
            left out. Without unit.
        tilt: Misalignment in the plane of axis and normal, in mrad: positive brings the end at
            positive y closer to the other body; 0 if it is left out. The approach is that of
            the middle. Without unit.
        material: a name among `materials`, `material(...)` or `rigid`.
        support: how its far boundary is held: "clamped" (default) or "roller".
    """
    return build_body(Roller, material, support, length=length, radius=radius, crown_radius=crown_radius, design_force=design_force, moment=moment, points=points, profile=profile, rotation=rotation, tilt=tilt)


def sphere(
    *,
    radius: Number,
    material: Material,
    rotation: Number | None = None,
    support: Support | None = None,
) -> ContactBody:
    """A ball: in axisymmetry half a sphere, held at its diametral plane; in three dimensions a
    half-space with its curvature.

    Args:
        radius: Radius.
        rotation: Angle of the body about the normal, in degrees, from x towards y; 0 if it is left
            out. Only in three dimensions. Without unit.
        material: a name among `materials`, `material(...)` or `rigid`.
        support: how its far boundary is held: "clamped" (default) or "roller".
    """
    return build_body(Sphere, material, support, radius=radius, rotation=rotation)


def wedge(
    *,
    angle: Number,
    depth: Number,
    width: Number,
    material: Material,
    tip_radius: Number | None = None,
    support: Support | None = None,
) -> ContactBody:
    """Two plane flanks that meet in a tip; only in plane analyses.

    Args:
        angle: Angle β of the flanks to the tangential plane, in degrees. Without unit.
        depth: From the tip to the base, more than the height of the flanks.
        width: Full width.
        tip_radius: Radius of the tip; sharp if it is left out.
        material: a name among `materials`, `material(...)` or `rigid`.
        support: how its far boundary is held: "clamped" (default) or "roller".
    """
    return build_body(Wedge, material, support, angle=angle, depth=depth, width=width, tip_radius=tip_radius)


def bilinear(
    *,
    tangent_modulus: Number,
    yield_stress: Number,
    backstress: Sequence[Any] | None = None,
    over_depth: Any = None,
) -> Bilinear:
    """A straight line beyond the yield stress.

    Args:
        tangent_modulus: Slope E_t of stress over total strain beyond yield, below E; 0 is perfectly
            plastic.
        yield_stress: Yield stress σ_y.
        backstress: Terms of the backstress, for flow theory.
        over_depth: How the stresses of the curve vary with the depth.
    """
    return build_law(Bilinear, tangent_modulus=tangent_modulus, yield_stress=yield_stress, backstress=backstress, over_depth=over_depth)


def ludwik(
    *,
    coefficient: Number,
    exponent: Number,
    yield_stress: Number,
    backstress: Sequence[Any] | None = None,
    over_depth: Any = None,
) -> Ludwik:
    """q = σ_y + k ε_p^n.

    Args:
        coefficient: Coefficient k.
        exponent: Exponent n. Without unit.
        yield_stress: Yield stress σ_y.
        backstress: Terms of the backstress, for flow theory.
        over_depth: How the stresses of the curve vary with the depth.
    """
    return build_law(Ludwik, coefficient=coefficient, exponent=exponent, yield_stress=yield_stress, backstress=backstress, over_depth=over_depth)


def ramberg_osgood(
    *,
    exponent: Number,
    offset: Number,
    reference_stress: Number,
    backstress: Sequence[Any] | None = None,
    over_depth: Any = None,
) -> RambergOsgood:
    """ε_p = a (σ_0/E) (q/σ_0)^m.

    Args:
        exponent: Exponent m, from linear to, for every purpose, perfectly plastic. Without unit.
        offset: Offset a. Without unit.
        reference_stress: Reference stress σ_0.
        backstress: Terms of the backstress, for flow theory.
        over_depth: How the stresses of the curve vary with the depth.
    """
    return build_law(RambergOsgood, exponent=exponent, offset=offset, reference_stress=reference_stress, backstress=backstress, over_depth=over_depth)


def swift(
    *,
    exponent: Number,
    strain_offset: Number,
    yield_stress: Number,
    backstress: Sequence[Any] | None = None,
    over_depth: Any = None,
) -> Swift:
    """q = σ_y (1 + ε_p/ε_0)^n.

    Args:
        exponent: Exponent n. Without unit.
        strain_offset: Strain offset ε_0. Without unit.
        yield_stress: Yield stress σ_y.
        backstress: Terms of the backstress, for flow theory.
        over_depth: How the stresses of the curve vary with the depth.
    """
    return build_law(Swift, exponent=exponent, strain_offset=strain_offset, yield_stress=yield_stress, backstress=backstress, over_depth=over_depth)


def table(
    *,
    points: Sequence[tuple[Number, Number]] | Sequence[Sequence[Number]] | Any,
    backstress: Sequence[Any] | None = None,
    over_depth: Any = None,
) -> Table:
    """A measured curve.

    Args:
        points: Points `[plastic_strain, stress]`, joined by straight lines, constant beyond the
            last.
        backstress: Terms of the backstress, for flow theory.
        over_depth: How the stresses of the curve vary with the depth.
    """
    return build_law(Table, points=points, backstress=backstress, over_depth=over_depth)


def voce(
    *,
    rate: Number,
    saturation_stress: Number,
    yield_stress: Number,
    backstress: Sequence[Any] | None = None,
    over_depth: Any = None,
) -> Voce:
    """q = σ_y + (σ_s − σ_y) (1 − exp(−b ε_p)).

    Args:
        rate: Rate b. Without unit.
        saturation_stress: Saturation stress σ_s, at least σ_y.
        yield_stress: Yield stress σ_y.
        backstress: Terms of the backstress, for flow theory.
        over_depth: How the stresses of the curve vary with the depth.
    """
    return build_law(Voce, rate=rate, saturation_stress=saturation_stress, yield_stress=yield_stress, backstress=backstress, over_depth=over_depth)
