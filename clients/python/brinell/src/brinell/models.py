# Generated from api/openapi.json by clients/python/scripts/models.sh; do not edit.

from __future__ import annotations

from typing import Annotated, Any, Literal

from brinell._model import BaseModel
from pydantic import ConfigDict, Field, RootModel, StringConstraints
from typing_extensions import TypeAliasType


class ApproachLoad(BaseModel):
    """
    An approach; the force is an output.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    approach: Annotated[
        float,
        Field(
            description='Approach α of the two supports. Range: 1e-9 to 1e6 mm or 1e-12 to 1e3 m.',
            examples=[0.02],
            ge=1e-12,
            le=1000000.0,
        ),
    ]
    approaches: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    force: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    forces: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    hardness: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    history: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    onset: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    rolling: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    target: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None


class Approach(RootModel[float]):
    root: Annotated[
        float,
        Field(
            description='Approach α of the two supports. Range: 1e-9 to 1e6 mm or 1e-12 to 1e3 m.',
            ge=1e-12,
            le=1000000.0,
        ),
    ]


class ApproachesLoad(BaseModel):
    """
    A sweep of approaches.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    approach: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    approaches: Annotated[
        list[Approach],
        Field(
            description='In the order in which they are applied.',
            examples=[[0.01, 0.02]],
            max_length=1000,
            min_length=1,
        ),
    ]
    force: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    forces: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    hardness: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    history: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    onset: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    rolling: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    target: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None


class BackstressTerm(BaseModel):
    """
    One term of the backstress X, with dX = 2/3 C dε_p - γ X dp: Prager's law where γ is zero, Armstrong and Frederick's elsewhere; several terms are Chaboche's.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    modulus: Annotated[
        float,
        Field(
            description='Modulus C. Range: 1e-3 to 1e8 MPa or 1e3 to 1e14 Pa.',
            examples=[20000.0],
            ge=0.001,
            le=100000000000000.0,
        ),
    ]
    rate: Annotated[
        float,
        Field(
            description='Rate of recovery γ. Without unit.',
            examples=[100.0],
            ge=0.0,
            le=1000000.0,
        ),
    ]


class Block(BaseModel):
    """
    A rectangle, held at its base.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    depth: Annotated[
        float,
        Field(
            description='Height of the rectangle below the contact. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[200.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    type: Annotated[
        Literal['block'], Field(description='The word that names this kind.')
    ]
    width: Annotated[
        float,
        Field(
            description='Full width, centred on the contact. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[200.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]


class Cone(BaseModel):
    """
    A flank of revolution that ends in a tip; only in axisymmetry.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    angle: Annotated[
        float,
        Field(
            description='Angle β of the flank to the tangential plane, in degrees. Without unit.',
            examples=[5.0],
            ge=0.001,
            le=60.0,
        ),
    ]
    depth: Annotated[
        float,
        Field(
            description='From the tip to the base, more than the height of the flank. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[50.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    tip_radius: Annotated[
        float | None,
        Field(
            description='Radius of the tip; sharp if it is left out. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            ge=1e-09,
            le=1000000.0,
        ),
    ] = None
    type: Annotated[
        Literal['cone'], Field(description='The word that names this kind.')
    ]
    width: Annotated[
        float,
        Field(
            description='Diameter of the base. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[40.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]


class Curved(BaseModel):
    """
    A half-space whose surface has a curvature along its x and one along its y: roller, raceway, crowned part; only in three dimensions.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    radius_x: Annotated[
        float | None,
        Field(
            description='Radius of curvature along its x; negative is concave, left out is straight. Range: -1e6 to 1e6 mm or -1e3 to 1e3 m.',
            examples=[10.0],
            ge=-1000000.0,
            le=1000000.0,
        ),
    ] = None
    radius_y: Annotated[
        float | None,
        Field(
            description='Radius of curvature along its y; negative is concave, left out is straight. Range: -1e6 to 1e6 mm or -1e3 to 1e3 m.',
            examples=[50.0],
            ge=-1000000.0,
            le=1000000.0,
        ),
    ] = None
    rotation: Annotated[
        float | None,
        Field(
            description='Angle of its x from that of the contact plane, in degrees, towards y; 0 if it is left out. Without unit.',
            ge=-360.0,
            le=360.0,
        ),
    ] = None
    type: Annotated[
        Literal['curved'], Field(description='The word that names this kind.')
    ]


class Cylinder(BaseModel):
    """
    Half a cylinder, held at its diametral plane. In axisymmetry it is read as a `sphere`.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    radius: Annotated[
        float,
        Field(
            description='Radius. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[20.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    type: Annotated[
        Literal['cylinder'], Field(description='The word that names this kind.')
    ]


class DentDepthTarget(BaseModel):
    """
    Depth below the undeformed surface of the deeper of the two dents that are left when the force is taken away.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    dent_depth: Annotated[
        float,
        Field(
            description='Depth below the undeformed surface of the deeper of the two dents that are left when the force is taken away. Range: 1e-9 to 1e6 mm or 1e-12 to 1e3 m.',
            examples=[0.001],
            ge=1e-12,
            le=1000000.0,
        ),
    ]
    half_width: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    max_plastic_strain: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    mean_pressure: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    peak_pressure: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    permanent_approach: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None


class Ellipse(BaseModel):
    """
    Half an ellipse, held at its axis along x.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    semi_axis_x: Annotated[
        float,
        Field(
            description='Half its extent along x. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[30.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    semi_axis_y: Annotated[
        float,
        Field(
            description='Half its extent along y. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[20.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    type: Annotated[
        Literal['ellipse'], Field(description='The word that names this kind.')
    ]


class FatigueOfHardness(BaseModel):
    """
    Limits from the hardness over depth by f_w = 1.6 HV up to 400 HV, t_w = f_w/√3.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    bending: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    from_hardness: Annotated[Literal[True], Field(description='Always true.')]
    torsion: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None


class Vary(RootModel[str]):
    root: Annotated[
        str,
        Field(
            description='JSON pointer of a number of the bodies or the load, or a list of those that all take the value.',
            examples=['/upper/shape/crown_radius'],
            pattern='^/',
        ),
    ]


class Vary1Item(RootModel[str]):
    root: Annotated[str, Field(pattern='^/')]


class Vary1(RootModel[list[Vary1Item]]):
    root: Annotated[
        list[Vary1Item],
        Field(
            description='JSON pointer of a number of the bodies or the load, or a list of those that all take the value.',
            examples=['/upper/shape/crown_radius'],
            max_length=8,
            min_length=1,
        ),
    ]


class FindUntil(BaseModel):
    """
    What shall be: one figure with its value, in its own unit, or `least` or `most`.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    approach: Annotated[
        float | None,
        Field(description='Wanted value: how far the bodies have approached.'),
    ] = None
    body: Annotated[
        Literal['upper', 'lower'] | None,
        Field(description='Of which body the figure is, where both have it.'),
    ] = None
    constraint_factor: Annotated[
        float | None,
        Field(
            description="Wanted value: mean pressure over the flow stress; Tabor's is 2.8."
        ),
    ] = None
    contact_area: Annotated[
        float | None,
        Field(
            description='Wanted value: area of the contact; of heights that of the cells in contact.'
        ),
    ] = None
    contact_ratio: Annotated[
        float | None,
        Field(
            description='Wanted value: cells in contact over the area of all heights.'
        ),
    ] = None
    contact_stiffness: Annotated[
        float | None,
        Field(
            description='Wanted value: slope of the force over the approach, with the plastic flow that it brings.'
        ),
    ] = None
    dent_depth: Annotated[
        float | None,
        Field(
            description='Wanted value: deepest point of the unloaded surface below the undeformed one.'
        ),
    ] = None
    diameter: Annotated[
        float | None,
        Field(
            description='Wanted value: under the force; of pyramids the diagonal of a square of equal area.'
        ),
    ] = None
    effective_radius: Annotated[
        float | None,
        Field(
            description='Wanted value: reciprocal of the sum of both curvatures across the shorter side of the contact.'
        ),
    ] = None
    fatigue_utilization: Annotated[
        float | None,
        Field(
            description='Wanted value: shear stress of a criterion of high-cycle fatigue over the fatigue limit in torsion, largest of all depths.'
        ),
    ] = None
    first_yield_force: Annotated[
        float | None,
        Field(
            description='Wanted value: force under which a body begins to yield, of half-spaces; `load.onset` looks for `force`.'
        ),
    ] = None
    flow_stress: Annotated[
        float | None,
        Field(description='Wanted value: of the curve at the representative strain.'),
    ] = None
    force: Annotated[
        float | None, Field(description='Wanted value: contact force.')
    ] = None
    forward_displacement: Annotated[
        float | None,
        Field(
            description='Wanted value: of the surface along the travel, by the last pass.'
        ),
    ] = None
    friction: Annotated[
        float | None,
        Field(description='Wanted value: traction over pressure in the whole contact.'),
    ] = None
    half_angle: Annotated[
        float | None,
        Field(
            description='Wanted value: over which a pin touches its hole to each side of the middle.'
        ),
    ] = None
    half_width: Annotated[
        float | None,
        Field(
            description='Wanted value: half of the distance between the ends of the contact; of a circle its radius.'
        ),
    ] = None
    half_width_across: Annotated[
        float | None,
        Field(description='Wanted value: half-width of the contact across the travel.'),
    ] = None
    hardness: Annotated[
        float | None,
        Field(
            description='Wanted value: number of a test by a standard; of `berkovich` and `sphere` see `meyer_hardness`.'
        ),
    ] = None
    indentation_area: Annotated[
        float | None, Field(description='Wanted value: under the force.')
    ] = None
    indentation_depth: Annotated[
        float | None, Field(description='Wanted value: under the force.')
    ] = None
    largest_sigma_x: Annotated[
        float | None,
        Field(description='Wanted value: along the travel, largest over depth.'),
    ] = None
    largest_sigma_z: Annotated[
        float | None,
        Field(description='Wanted value: across the travel, largest over depth.'),
    ] = None
    largest_von_mises: Annotated[
        float | None,
        Field(
            description='Wanted value: on the normal below the middle, over the strength there, that of the surface being 1.'
        ),
    ] = None
    least: Annotated[
        Literal['hardness', 'first_yield_force', 'strain_per_pass', 'track_depth', 'forward_displacement', 'pass_strain', 'net_strain', 'least_sigma_x', 'largest_sigma_x', 'least_sigma_z', 'largest_sigma_z', 'rolling_force', 'rolling_resistance', 'pass_work', 'friction', 'dent_depth', 'surface_depth', 'pile_up', 'permanent_approach', 'contact_ratio', 'nominal_pressure', 'moment', 'tilt', 'peak_pressure', 'middle_pressure', 'half_width', 'half_width_across', 'semi_axis_a', 'semi_axis_b', 'approach', 'force', 'mean_pressure', 'max_plastic_strain', 'mean_plastic_strain', 'utilization', 'margin', 'fatigue_utilization', 'shakedown_pressure', 'effective_radius', 'contact_stiffness', 'half_angle', 'orientation', 'contact_area', 'least_stress', 'largest_von_mises', 'plastic_area', 'shear_yield_stress', 'meyer_hardness', 'diameter', 'indentation_depth', 'indentation_area', 'representative_strain', 'flow_stress', 'constraint_factor', 'oliver_pharr_modulus', 'oliver_pharr_hardness', 'reduced_modulus'] | None,
        Field(description='Figure that shall be as small as it becomes.'),
    ] = None
    least_sigma_x: Annotated[
        float | None,
        Field(description='Wanted value: along the travel, least over depth.'),
    ] = None
    least_sigma_z: Annotated[
        float | None,
        Field(description='Wanted value: across the travel, least over depth.'),
    ] = None
    least_stress: Annotated[
        float | None,
        Field(
            description='Wanted value: on the normal below the middle; without force the residual stress.'
        ),
    ] = None
    margin: Annotated[
        float | None,
        Field(description='Wanted value: force of first yield over the force.'),
    ] = None
    max_plastic_strain: Annotated[
        float | None,
        Field(description='Wanted value: accumulated since the bodies were at rest.'),
    ] = None
    mean_plastic_strain: Annotated[
        float | None,
        Field(
            description='Wanted value: mean equivalent plastic strain over the area of the section that has yielded.'
        ),
    ] = None
    mean_pressure: Annotated[
        float | None, Field(description='Wanted value: force over the contact.')
    ] = None
    meyer_hardness: Annotated[
        float | None,
        Field(
            description='Wanted value: force over the area of the indentation under it; the answer of `berkovich` and `sphere`.'
        ),
    ] = None
    middle_pressure: Annotated[
        float | None,
        Field(
            description='Wanted value: contact pressure in the middle, where that is not the peak; of a roller the largest across its middle.'
        ),
    ] = None
    moment: Annotated[
        float | None,
        Field(
            description='Wanted value: of the pressure about the middle, positive towards y.'
        ),
    ] = None
    most: Annotated[
        Literal['hardness', 'first_yield_force', 'strain_per_pass', 'track_depth', 'forward_displacement', 'pass_strain', 'net_strain', 'least_sigma_x', 'largest_sigma_x', 'least_sigma_z', 'largest_sigma_z', 'rolling_force', 'rolling_resistance', 'pass_work', 'friction', 'dent_depth', 'surface_depth', 'pile_up', 'permanent_approach', 'contact_ratio', 'nominal_pressure', 'moment', 'tilt', 'peak_pressure', 'middle_pressure', 'half_width', 'half_width_across', 'semi_axis_a', 'semi_axis_b', 'approach', 'force', 'mean_pressure', 'max_plastic_strain', 'mean_plastic_strain', 'utilization', 'margin', 'fatigue_utilization', 'shakedown_pressure', 'effective_radius', 'contact_stiffness', 'half_angle', 'orientation', 'contact_area', 'least_stress', 'largest_von_mises', 'plastic_area', 'shear_yield_stress', 'meyer_hardness', 'diameter', 'indentation_depth', 'indentation_area', 'representative_strain', 'flow_stress', 'constraint_factor', 'oliver_pharr_modulus', 'oliver_pharr_hardness', 'reduced_modulus'] | None,
        Field(description='Figure that shall be as large as it becomes.'),
    ] = None
    net_strain: Annotated[
        float | None,
        Field(description='Wanted value: kept by the pass, largest of all layers.'),
    ] = None
    nominal_pressure: Annotated[
        float | None,
        Field(description='Wanted value: force over the area of all heights.'),
    ] = None
    oliver_pharr_hardness: Annotated[
        float | None, Field(description='Wanted value: force over that area.')
    ] = None
    oliver_pharr_modulus: Annotated[
        float | None, Field(description='Wanted value: √π S / (2 √A).')
    ] = None
    orientation: Annotated[
        float | None,
        Field(
            description='Wanted value: angle from the x of the job to the x of the figures, towards the y of the job.'
        ),
    ] = None
    pass_strain: Annotated[
        float | None,
        Field(
            description='Wanted value: accumulated by the pass, largest of all layers.'
        ),
    ] = None
    pass_work: Annotated[
        float | None,
        Field(
            description='Wanted value: of plastic flow in both bodies, per length of travel.'
        ),
    ] = None
    peak_pressure: Annotated[
        float | None, Field(description='Wanted value: largest contact pressure.')
    ] = None
    permanent_approach: Annotated[
        float | None, Field(description='Wanted value: approach without force.')
    ] = None
    pile_up: Annotated[
        float | None,
        Field(
            description='Wanted value: highest point of the surface above the undeformed one.'
        ),
    ] = None
    plastic_area: Annotated[
        float | None,
        Field(description='Wanted value: area of the section that has yielded.'),
    ] = None
    reduced_modulus: Annotated[
        float | None, Field(description='Wanted value: E* of both materials.')
    ] = None
    representative_strain: Annotated[
        float | None,
        Field(
            description="Wanted value: Tabor's plastic strain: 0.2 a/R of a ball, 0.08 of a pyramid."
        ),
    ] = None
    rolling_force: Annotated[
        float | None,
        Field(
            description='Wanted value: against the travel in the pass, without friction.'
        ),
    ] = None
    rolling_resistance: Annotated[
        float | None, Field(description='Wanted value: rolling force over the load.')
    ] = None
    semi_axis_a: Annotated[
        float | None,
        Field(description='Wanted value: shorter semi-axis of the contact.'),
    ] = None
    semi_axis_b: Annotated[
        float | None,
        Field(description='Wanted value: longer semi-axis of the contact.'),
    ] = None
    shakedown_pressure: Annotated[
        float | None,
        Field(
            description="Wanted value: Hertz's peak up to which perfect plasticity shakes down."
        ),
    ] = None
    shear_yield_stress: Annotated[
        float | None,
        Field(
            description='Wanted value: of both bodies the lower, where strength does not vary: the scale of the map of shakedown.'
        ),
    ] = None
    strain_per_pass: Annotated[
        float | None,
        Field(
            description='Wanted value: plastic strain that each steady pass, or pair of passes, adds or moves.'
        ),
    ] = None
    surface_depth: Annotated[
        float | None,
        Field(
            description='Wanted value: deepest point of the loaded surface below the undeformed one.'
        ),
    ] = None
    tilt: Annotated[
        float | None,
        Field(
            description='Wanted value: positive where the surfaces are closer at positive y.'
        ),
    ] = None
    track_depth: Annotated[
        float | None,
        Field(description='Wanted value: how far the surface has sunk, on the axis.'),
    ] = None
    utilization: Annotated[
        float | None,
        Field(
            description='Wanted value: largest von Mises stress of elastic bodies over the yield stress there.'
        ),
    ] = None


class Flat(BaseModel):
    """
    A plane half-space; only in three dimensions.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    rotation: Annotated[
        float | None,
        Field(
            description='Angle of the body about the normal, in degrees, from x towards y; 0 if it is left out. Without unit.',
            ge=-360.0,
            le=360.0,
        ),
    ] = None
    type: Annotated[
        Literal['flat'], Field(description='The word that names this kind.')
    ]


class ForceLoad(BaseModel):
    """
    A force; the approach is an output.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    approach: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    approaches: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    force: Annotated[
        float,
        Field(
            description='Force of the whole contact, both sides of the axis: on unit thickness, in axisymmetry and three dimensions in all. Range: 1e-9 to 1e9 N/mm or 1e-9 to 1e9 N or 1e-6 to 1e12 N/m.',
            examples=[612.6106],
            ge=1e-09,
            le=1000000000000.0,
        ),
    ]
    forces: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    hardness: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    history: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    onset: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    rolling: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    target: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None


class Force(RootModel[float]):
    root: Annotated[
        float,
        Field(
            description='Force of the whole contact, both sides of the axis: on unit thickness, in axisymmetry and three dimensions in all. Range: 1e-9 to 1e9 N/mm or 1e-9 to 1e9 N or 1e-6 to 1e12 N/m.',
            ge=1e-09,
            le=1000000000000.0,
        ),
    ]


class ForcesLoad(BaseModel):
    """
    A sweep of forces.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    approach: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    approaches: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    force: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    forces: Annotated[
        list[Force],
        Field(
            description='In the order in which they are applied.',
            examples=[[200.0, 400.0, 600.0]],
            max_length=1000,
            min_length=1,
        ),
    ]
    hardness: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    history: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    onset: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    rolling: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    target: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None


class GivenLimits(BaseModel):
    """
    Limits of high-cycle fatigue, which are the same at all depths: amplitudes of stress at a stress ratio of -1 that a polished specimen bears without end.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    bending: Annotated[
        float,
        Field(
            description='Limit in bending; the limit in torsion lies between a half of it and itself. Range: 1e-6 to 1e7 MPa or 1e0 to 1e13 Pa.',
            examples=[800.0],
            ge=1e-06,
            le=10000000000000.0,
        ),
    ]
    from_hardness: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    torsion: Annotated[
        float,
        Field(
            description='Limit in torsion, of the shear stress. Range: 1e-6 to 1e7 MPa or 1e0 to 1e13 Pa.',
            examples=[480.0],
            ge=1e-06,
            le=10000000000000.0,
        ),
    ]


class Groove(BaseModel):
    """
    A block with a concave circular trough across its whole upper face.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    depth: Annotated[
        float,
        Field(
            description='From the bottom of the trough to the base. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[50.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    radius: Annotated[
        float,
        Field(
            description='Radius of the trough. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[30.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    type: Annotated[
        Literal['groove'], Field(description='The word that names this kind.')
    ]
    width: Annotated[
        float,
        Field(
            description='Full width, at most twice the radius. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[40.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]


class HalfWidthTarget(BaseModel):
    """
    Half-width of the contact; its radius in axisymmetry, its shorter semi-axis in three dimensions.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    dent_depth: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    half_width: Annotated[
        float,
        Field(
            description='Half-width of the contact; its radius in axisymmetry, its shorter semi-axis in three dimensions. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[0.3],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    max_plastic_strain: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    mean_pressure: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    peak_pressure: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    permanent_approach: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None


class ProfileItemItem(RootModel[float]):
    root: Annotated[
        float,
        Field(
            description='Depth below the surface. Range: 0e0 to 1e6 mm or 0e0 to 1e3 m.',
            ge=0.0,
            le=1000000.0,
        ),
    ]


class ProfileItemItem1(RootModel[float]):
    root: Annotated[
        float,
        Field(
            description='Hardness, HV unless `hardness_scale` says HRC. Without unit.',
            ge=20.3,
            le=2000.0,
        ),
    ]


class ProfileItem(RootModel[tuple[ProfileItemItem, ProfileItemItem1]]):
    root: Annotated[
        tuple[ProfileItemItem, ProfileItemItem1],
        Field(description='One point.', max_length=2, min_length=2),
    ]


class History(BaseModel):
    """
    One load of a history; zero takes it away.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    force: Annotated[
        float,
        Field(
            description='Force of the whole contact, both sides of the axis: on unit thickness, in axisymmetry and three dimensions in all. Range: 1e-9 to 1e9 N/mm or 1e-9 to 1e9 N or 1e-6 to 1e12 N/m.',
            ge=0.0,
            le=1000000000000.0,
        ),
    ]


class History1(BaseModel):
    """
    One load of a history; zero takes it away.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    approach: Annotated[
        float,
        Field(
            description='Approach α of the two supports. Range: 1e-9 to 1e6 mm or 1e-12 to 1e3 m.',
            ge=0.0,
            le=1000000.0,
        ),
    ]


class HistoryLoad(BaseModel):
    """
    Loads one after the other, each on what the one before has left.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    approach: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    approaches: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    force: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    forces: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    hardness: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    history: Annotated[
        list[History | History1],
        Field(
            description='In the order in which they are applied, at least one of them above zero. Under `deformation` each stands alone.',
            examples=[[{'force': 612.6106}, {'force': 0.0}]],
            max_length=1000,
            min_length=1,
        ),
    ]
    onset: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    rolling: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    target: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None


class Hole(BaseModel):
    """
    A round hole in the middle of a disc or of a square plate, which holds a `cylinder` with clearance; in axisymmetry the spherical socket of a ball. Its outer edge is the support. Give `outer_radius` or `width`.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    outer_radius: Annotated[
        float | None,
        Field(
            description='Radius of the disc, larger than that of the hole. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[200.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ] = None
    radius: Annotated[
        float,
        Field(
            description='Radius of the hole, larger than that of the cylinder in it. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[20.1],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    type: Annotated[
        Literal['hole'], Field(description='The word that names this kind.')
    ]
    width: Annotated[
        float | None,
        Field(
            description='Width of the square plate, in place of `outer_radius`; only in plane analyses. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            ge=1e-09,
            le=1000000.0,
        ),
    ] = None


class InitialStress(BaseModel):
    """
    Stress along the surface at one depth, before any load; straight between depths, constant beyond the ends.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    depth: Annotated[
        float,
        Field(
            description='Depth below the surface. Range: 0e0 to 1e6 mm or 0e0 to 1e3 m.',
            examples=[0.05],
            ge=0.0,
            le=1000000.0,
        ),
    ]
    sigma_x: Annotated[
        float,
        Field(
            description='Stress along the surface in the plane of the section, in three dimensions along x; tension positive. Range: -1e7 to 1e7 MPa or -1e13 to 1e13 Pa.',
            examples=[-600.0],
            ge=-10000000000000.0,
            le=10000000000000.0,
        ),
    ]
    sigma_z: Annotated[
        float,
        Field(
            description='Stress along the surface out of that plane, in three dimensions along y, in axisymmetry equal to `sigma_x`, in plane stress zero. Range: -1e7 to 1e7 MPa or -1e13 to 1e13 Pa.',
            examples=[-600.0],
            ge=-10000000000000.0,
            le=10000000000000.0,
        ),
    ]


class MaxPlasticStrainTarget(BaseModel):
    """
    Largest equivalent plastic strain of both bodies.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    dent_depth: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    half_width: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    max_plastic_strain: Annotated[
        float,
        Field(
            description='Largest equivalent plastic strain of both bodies. Without unit.',
            examples=[0.01],
            ge=1e-09,
            le=1.0,
        ),
    ]
    mean_pressure: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    peak_pressure: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    permanent_approach: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None


class MeanPressureTarget(BaseModel):
    """
    Force over the width of the contact or, in axisymmetry and three dimensions, over its area.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    dent_depth: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    half_width: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    max_plastic_strain: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    mean_pressure: Annotated[
        float,
        Field(
            description='Force over the width of the contact or, in axisymmetry and three dimensions, over its area. Range: 1e-6 to 1e7 MPa or 1e0 to 1e13 Pa.',
            examples=[1200.0],
            ge=1e-06,
            le=10000000000000.0,
        ),
    ]
    peak_pressure: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    permanent_approach: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None


class MeshSettings(BaseModel):
    """
    The mesh.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    accuracy: Annotated[
        float | None,
        Field(
            description='Bound of the relative errors of the figures that answer the job, as 0.01. Mesh and increments are refined until they are met, to four times the elements at most; `validity` of the result names the figure that misses it. Without it one mesh is solved. Without unit.',
            ge=0.001,
            le=0.2,
        ),
    ] = None
    elements_per_half_width: Annotated[
        int | None,
        Field(
            description='Elements over one contact half-width; in three dimensions cells over each semi-axis, 10 of them if it is left out. Default: `20`.',
            ge=4,
            le=320,
        ),
    ] = None


class NpyHeights(BaseModel):
    """
    Heights as an array of numpy, which takes fewer bytes than lists and no digit away.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    npy_base64: Annotated[
        str,
        Field(
            description='Base64 of what numpy.save writes: two dimensions, little-endian float64 or float32, in the units of lists. Not NaN.'
        ),
    ]


class OnsetLoad(BaseModel):
    """
    The force at which the contact begins to yield is the answer.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    approach: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    approaches: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    force: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    forces: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    hardness: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    history: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    onset: Annotated[Literal[True], Field(description='Always true.')]
    rolling: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    target: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None


class OutputSettings(BaseModel):
    """
    What the result contains beside the contact itself.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    contact_stiffness: Annotated[
        bool | None,
        Field(
            description='Contact stiffness of bodies that yield too, from two more solves of each step on small meshes. Default: `false`.'
        ),
    ] = None
    fields: Annotated[
        bool | None,
        Field(description='Mesh and nodal fields, some megabytes. Default: `false`.'),
    ] = None
    subsurface: Annotated[
        bool | None,
        Field(
            description='Stresses over depth under the peak pressure. Default: `true`.'
        ),
    ] = None


class Parabola(BaseModel):
    """
    A block with the surface y = −x²/2R.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    depth: Annotated[
        float,
        Field(
            description='From the vertex to the base, more than the fall of the surface at its ends. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[50.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    radius: Annotated[
        float,
        Field(
            description='Radius of curvature at the vertex. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[20.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    type: Annotated[
        Literal['parabola'], Field(description='The word that names this kind.')
    ]
    width: Annotated[
        float,
        Field(
            description='Full width. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[30.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]


class PeakPressureTarget(BaseModel):
    """
    Largest contact pressure.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    dent_depth: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    half_width: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    max_plastic_strain: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    mean_pressure: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    peak_pressure: Annotated[
        float,
        Field(
            description='Largest contact pressure. Range: 1e-6 to 1e7 MPa or 1e0 to 1e13 Pa.',
            examples=[1200.0],
            ge=1e-06,
            le=10000000000000.0,
        ),
    ]
    permanent_approach: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None


class PermanentApproachTarget(BaseModel):
    """
    Approach that is left when the force is taken away.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    dent_depth: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    half_width: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    max_plastic_strain: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    mean_pressure: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    peak_pressure: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    permanent_approach: Annotated[
        float,
        Field(
            description='Approach that is left when the force is taken away. Range: 1e-9 to 1e6 mm or 1e-12 to 1e3 m.',
            examples=[0.001],
            ge=1e-12,
            le=1000000.0,
        ),
    ]


class Power(BaseModel):
    """
    A block with the surface y = −L (|x|/L)^n.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    depth: Annotated[
        float,
        Field(
            description='From the vertex to the base, more than the fall of the surface at its ends. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[50.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    exponent: Annotated[
        float,
        Field(
            description='Exponent n; 2 is a parabola, a large one nearly a flat punch. Without unit.',
            examples=[4.0],
            ge=1.05,
            le=50.0,
        ),
    ]
    scale: Annotated[
        float,
        Field(
            description='Length L, the distance at which the surface has fallen by as much. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[30.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    type: Annotated[
        Literal['power'], Field(description='The word that names this kind.')
    ]
    width: Annotated[
        float,
        Field(
            description='Full width. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[30.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]


class PrescribedApproach(BaseModel):
    """
    Approach. Unit: mm (SI: m).
    """

    approach: Annotated[float, Field(description='Approach. Unit: mm (SI: m).')]


class PrescribedForce(BaseModel):
    """
    Total force. Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions.
    """

    force: Annotated[
        float,
        Field(
            description='Total force. Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions.',
            ge=0.0,
        ),
    ]


class PointItem(RootModel[float]):
    root: Annotated[
        float,
        Field(
            description='x, tangential. Range: -1e6 to 1e6 mm or -1e3 to 1e3 m.',
            ge=-1000000.0,
            le=1000000.0,
        ),
    ]


class PointItem1(RootModel[float]):
    root: Annotated[
        float,
        Field(
            description='Height. Range: -1e6 to 1e6 mm or -1e3 to 1e3 m.',
            ge=-1000000.0,
            le=1000000.0,
        ),
    ]


class Point(RootModel[tuple[PointItem, PointItem1]]):
    root: Annotated[
        tuple[PointItem, PointItem1],
        Field(description='One point.', max_length=2, min_length=2),
    ]


class Profile(BaseModel):
    """
    A block whose upper face passes through points, smooth or straight between them.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    depth: Annotated[
        float,
        Field(
            description='From height 0 to the base; every height is above it. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[50.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    interpolation: Annotated[
        Literal['smooth', 'linear'] | None,
        Field(
            description='What the face is like between its points: `smooth` to the first derivative, without overshoot, or `linear`, so that points are corners. If it is left out, the face is smooth, and refused where that would round off a corner in the contact.'
        ),
    ] = None
    points: Annotated[
        list[Point],
        Field(
            description='Points `[x, height]`, x rising and passing 0. A face that starts or ends at x = 0 is completed by its mirror image.',
            examples=[[[-10.0, -2.5], [-4.0, -0.4], [0.0, 0.0], [4.0, -0.4], [10.0, -2.5]]],
            max_length=10000,
            min_length=2,
        ),
    ]
    type: Annotated[
        Literal['profile'], Field(description='The word that names this kind.')
    ]


class Punch(BaseModel):
    """
    A rigid flat punch with sharp or rounded edges.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    depth: Annotated[
        float,
        Field(
            description='Height of the side walls, more than the edge radius. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[20.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    edge_radius: Annotated[
        float | None,
        Field(
            description='Radius of the edges, less than half the width; sharp if it is 0 or left out. Range: 0e0 to 1e6 mm or 0e0 to 1e3 m.',
            ge=0.0,
            le=1000000.0,
        ),
    ] = None
    type: Annotated[
        Literal['punch'], Field(description='The word that names this kind.')
    ]
    width: Annotated[
        float,
        Field(
            description='Full width with the edges, the diameter in axisymmetry. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[10.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]


class Rigid(BaseModel):
    """
    A body that does not deform.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    fatigue: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    initial_stress: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    name: Annotated[
        str | None,
        Field(
            description='What the material is called; figures alone count.',
            max_length=80,
            min_length=1,
            pattern='^[^\\u0000-\\u001f\\u007f-\\u009f]*$',
        ),
    ] = None
    plasticity: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    poisson_ratio: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    rigid: Annotated[Literal[True], Field(description='Always true.')]
    young_modulus: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None


class Point1Item(RootModel[float]):
    root: Annotated[
        float,
        Field(
            description='y, along the axis from the middle. Range: -1e6 to 1e6 mm or -1e3 to 1e3 m.',
            ge=-1000000.0,
            le=1000000.0,
        ),
    ]


class Point1Item1(RootModel[float]):
    root: Annotated[
        float,
        Field(
            description='Height over the cylinder, negative where the surface falls. Range: -1e6 to 1e6 mm or -1e3 to 1e3 m.',
            ge=-1000000.0,
            le=1000000.0,
        ),
    ]


class Point1(RootModel[tuple[Point1Item, Point1Item1]]):
    root: Annotated[
        tuple[Point1Item, Point1Item1],
        Field(description='One point.', max_length=2, min_length=2),
    ]


class Sphere(BaseModel):
    """
    A ball: in axisymmetry half a sphere, held at its diametral plane; in three dimensions a half-space with its curvature.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    radius: Annotated[
        float,
        Field(
            description='Radius. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[20.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    rotation: Annotated[
        float | None,
        Field(
            description='Angle of the body about the normal, in degrees, from x towards y; 0 if it is left out. Only in three dimensions. Without unit.',
            ge=-360.0,
            le=360.0,
        ),
    ] = None
    type: Annotated[
        Literal['sphere'], Field(description='The word that names this kind.')
    ]


class StrengthFactorItem(RootModel[float]):
    root: Annotated[
        float,
        Field(
            description='Depth below the surface. Range: 0e0 to 1e6 mm or 0e0 to 1e3 m.',
            ge=0.0,
            le=1000000.0,
        ),
    ]


class StrengthFactorItem1(RootModel[float]):
    root: Annotated[
        float,
        Field(
            description='Factor of the stresses of the hardening curve. Without unit.',
            ge=0.01,
            le=100.0,
        ),
    ]


class StrengthFactor(RootModel[tuple[StrengthFactorItem, StrengthFactorItem1]]):
    root: Annotated[
        tuple[StrengthFactorItem, StrengthFactorItem1],
        Field(description='One point.', max_length=2, min_length=2),
    ]


class StrengthFactors(RootModel[list[StrengthFactor]]):
    """
    Points `[depth, factor]`, depths rising, joined by straight lines, constant beyond the ends.
    """

    root: Annotated[
        list[StrengthFactor],
        Field(
            description='Points `[depth, factor]`, depths rising, joined by straight lines, constant beyond the ends.',
            examples=[[[0.0, 1.8], [0.5, 1.6], [1.5, 1.0]]],
            max_length=1000,
            min_length=1,
        ),
    ]


class Height(RootModel[list[float]]):
    root: Annotated[list[float], Field(max_length=1024, min_length=8)]


class Heights(RootModel[list[Height]]):
    root: Annotated[
        list[Height],
        Field(description='Rows of one length.', max_length=1024, min_length=8),
    ]


class SurfaceHeights(BaseModel):
    """
    Heights on top of the shape of a half-space. The contact is solved on their grid, and there is none beyond it.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    detrend: Annotated[
        Literal['none', 'plane'] | None,
        Field(description='What is taken away from the heights. Default: `none`.'),
    ] = None
    heights: Annotated[
        Heights | NpyHeights,
        Field(
            description='Heights along the outward normal at the middles of cells: `heights[i][j]` at the i-th x and the j-th y of the job, the middle of the grid at the origin. Lists, or an array of numpy.'
        ),
    ]
    spacing_x: Annotated[
        float,
        Field(
            description='Distance of heights along x. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[0.001],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    spacing_y: Annotated[
        float,
        Field(
            description='Distance of heights along y. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[0.001],
            ge=1e-09,
            le=1000000.0,
        ),
    ]


class Point2Item(RootModel[float]):
    root: Annotated[
        float,
        Field(
            description='Plastic strain, rising; the first is 0. Without unit.',
            ge=0.0,
            le=100.0,
        ),
    ]


class Point2Item1(RootModel[float]):
    root: Annotated[
        float,
        Field(
            description='Stress, never falling. Range: 1e-6 to 1e7 MPa or 1e0 to 1e13 Pa.',
            ge=1e-06,
            le=10000000000000.0,
        ),
    ]


class Point2(RootModel[tuple[Point2Item, Point2Item1]]):
    root: Annotated[
        tuple[Point2Item, Point2Item1],
        Field(description='One point.', max_length=2, min_length=2),
    ]


TagsAdditionalProperty = TypeAliasType(
    "TagsAdditionalProperty",
    Annotated[
        str, Field(max_length=256, pattern='^[^\\u0000-\\u001f\\u007f-\\u009f]*$')
    ],
)


class Tags(
    RootModel[dict[Annotated[str, StringConstraints(pattern=r'^[^\u0000-\u001f\u007f-\u009f]*$', min_length=1, max_length=64)], TagsAdditionalProperty]]
):
    root: Annotated[
        dict[Annotated[str, StringConstraints(pattern=r'^[^\u0000-\u001f\u007f-\u009f]*$', min_length=1, max_length=64)], TagsAdditionalProperty],
        Field(
            description='Labels: key to text, without control characters.',
            examples=[{'bearing': 'NU-210'}],
            max_length=32,
        ),
    ]


class TargetLoad(BaseModel):
    """
    The force under which a figure of the contact has a value is the answer.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    approach: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    approaches: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    force: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    forces: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    hardness: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    history: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    onset: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    rolling: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    target: Annotated[
        PermanentApproachTarget | DentDepthTarget | PeakPressureTarget | MeanPressureTarget | HalfWidthTarget | MaxPlasticStrainTarget,
        Field(
            description='A figure of the contact and the value that it is to have: exactly one of these.',
            examples=[{'peak_pressure': 1200.0}],
        ),
    ]


class TestedCurve(BaseModel):
    """
    A hardening curve from a test, in the units of the test.
    """

    beyond_necking: Annotated[
        int, Field(description='Number of points beyond necking, left out.', ge=0)
    ]
    elastic: Annotated[int, Field(description='Number of points up to yield.', ge=0)]
    fit_largest: Annotated[
        float,
        Field(
            description='Largest distance of a point from the curve. Unit: MPa (SI: Pa).'
        ),
    ]
    fit_rms: Annotated[
        float,
        Field(
            description='Root mean square of the distance of the points from the curve. Unit: MPa (SI: Pa).'
        ),
    ]
    fitted: Annotated[
        int,
        Field(
            description='Number of points beyond yield that the curve is fitted to.',
            ge=0,
        ),
    ]
    necking: Annotated[
        list[float] | None,
        Field(
            description='Engineering strain and stress at which the specimen necks; `null` if it does not.'
        ),
    ]
    points: Annotated[
        list[list[float]],
        Field(
            description='Points `[plastic_strain, stress]` of the law `table`, true stress. Unit: MPa (SI: Pa).'
        ),
    ]
    remarks: Annotated[
        list[str], Field(description='What was done to the record, in sentences.')
    ]
    slope: Annotated[
        float,
        Field(
            description="First slope of the record; Young's modulus where no part is straight. Unit: MPa (SI: Pa)."
        ),
    ]
    slope_error: Annotated[
        float,
        Field(description='Standard error of the slope over the slope. Without unit.'),
    ]
    straight: Annotated[
        list[float] | None,
        Field(
            description='Stresses between which the record is straight; `null` if no part is. Unit: MPa (SI: Pa).'
        ),
    ]
    toe: Annotated[
        float,
        Field(
            description='Strain at which the first line meets the axis; it is removed. Without unit.'
        ),
    ]
    unloading: Annotated[
        int,
        Field(
            description='Number of points of unloading and reloading, left out.', ge=0
        ),
    ]
    yield_stress: Annotated[
        float,
        Field(
            description='Stress at the place that counts as yield. Unit: MPa (SI: Pa).'
        ),
    ]


class Wedge(BaseModel):
    """
    Two plane flanks that meet in a tip; only in plane analyses.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    angle: Annotated[
        float,
        Field(
            description='Angle β of the flanks to the tangential plane, in degrees. Without unit.',
            examples=[5.0],
            ge=0.001,
            le=60.0,
        ),
    ]
    depth: Annotated[
        float,
        Field(
            description='From the tip to the base, more than the height of the flanks. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[50.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    tip_radius: Annotated[
        float | None,
        Field(
            description='Radius of the tip; sharp if it is left out. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            ge=1e-09,
            le=1000000.0,
        ),
    ] = None
    type: Annotated[
        Literal['wedge'], Field(description='The word that names this kind.')
    ]
    width: Annotated[
        float,
        Field(
            description='Full width. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[40.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]


class Find(BaseModel):
    """
    An input that is sought between two ends for what it does to a figure of the last load step. The result is that of the job with it.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    between: Annotated[
        list[float],
        Field(
            description='Ends of the search, the smaller one first, in the units of the job.',
            max_length=2,
            min_length=2,
        ),
    ]
    until: FindUntil
    vary: Annotated[
        Vary | Vary1,
        Field(
            description='JSON pointer of a number of the bodies or the load, or a list of those that all take the value.',
            examples=['/upper/shape/crown_radius'],
        ),
    ]


class HardenedCase(BaseModel):
    """
    Hardness of a hardened case.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    case_depth: Annotated[
        float,
        Field(
            description='Case depth: where the hardness has fallen to `limit`. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[1.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    core: Annotated[
        float,
        Field(
            description='Hardness of the core. Without unit.',
            examples=[380.0],
            ge=20.3,
            le=2000.0,
        ),
    ]
    curve: Annotated[
        Literal['error_function', 'lang'] | None,
        Field(
            description='Profile between surface and core: `error_function` unless given.'
        ),
    ] = None
    hardness_scale: Annotated[
        Literal['HV', 'HRC'] | None,
        Field(
            description='Scale of the hardness: `HV` unless given. `HRC` becomes HV by ISO 18265, table A.1.'
        ),
    ] = None
    limit: Annotated[
        float | None,
        Field(
            description='Hardness at the case depth: 550 HV unless given, as ISO 18203 has it for carburized cases. Nitrided cases have that of the core + 50 HV, induction-hardened ones 80 % of that of the surface. Without unit.',
            ge=20.3,
            le=2000.0,
        ),
    ] = None
    surface: Annotated[
        float,
        Field(
            description='Hardness of the surface, HV unless `hardness_scale` says HRC. Without unit.',
            examples=[720.0],
            ge=20.3,
            le=2000.0,
        ),
    ]


class HardnessProfile(BaseModel):
    """
    Hardness at points.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    hardness_scale: Annotated[
        Literal['HV', 'HRC'] | None,
        Field(
            description='Scale of the hardness: `HV` unless given. `HRC` becomes HV by ISO 18265, table A.1.'
        ),
    ] = None
    profile: Annotated[
        list[ProfileItem],
        Field(
            description='Points `[depth, hardness]`, depths rising, joined by straight lines, constant beyond the ends.',
            examples=[[[0.0, 720.0], [0.5, 640.0], [1.0, 500.0], [1.5, 400.0], [2.0, 380.0]]],
            max_length=1000,
            min_length=1,
        ),
    ]


class HardnessTest(BaseModel):
    """
    A hardness test of the lower body. It brings its indenter, so that there is no `upper`.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    ball: Annotated[
        float | None,
        Field(
            description='Diameter of the ball of `HBW` (10, 5, 2.5 or 1 mm) or `sphere`. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[10.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ] = None
    force: Annotated[
        float | None,
        Field(
            description='Force, in place of `force_kgf`. Range: 1e-9 to 1e9 N.',
            examples=[29420.0],
            ge=1e-09,
            le=1000000000.0,
        ),
    ] = None
    force_kgf: Annotated[
        float | None,
        Field(
            description='Force in kgf of 9.80665 N, as scales name it. Without unit.',
            examples=[3000.0],
            ge=1e-09,
            le=3000.0,
        ),
    ] = None
    indenter_poisson_ratio: Annotated[
        float | None,
        Field(
            description="Poisson's ratio of the indenter: 0.21 of tungsten carbide, 0.07 of diamond. Without unit.",
            examples=[0.21],
            ge=0.0,
            le=0.499999,
        ),
    ] = None
    indenter_young_modulus: Annotated[
        float | None,
        Field(
            description="Young's modulus of the indenter: 600 GPa of tungsten carbide for `HBW` and `HRB`, 1141 GPa of diamond for all others, unless given. Range: 1e-3 to 1e8 MPa or 1e3 to 1e14 Pa.",
            examples=[600000.0],
            ge=0.001,
            le=100000000000000.0,
        ),
    ] = None
    scale: Annotated[
        Literal['HBW', 'HV', 'berkovich', 'HRC', 'HRB', 'sphere'],
        Field(
            description='Scale: `HBW`, `HV`, `HRC` and `HRB` by ISO 6506, 6507 and 6508; `berkovich` and `sphere` for instrumented indentation.'
        ),
    ]
    tip_radius: Annotated[
        float | None,
        Field(
            description='Radius of the tip of `HV`, 0.5 µm unless given, or `berkovich`, 0.1 µm. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[0.0005],
            ge=1e-09,
            le=1000000.0,
        ),
    ] = None


class Roller(BaseModel):
    """
    A cylinder of finite length, whose axis is its y: a roller, a rib; only in three dimensions.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    crown_radius: Annotated[
        float | None,
        Field(
            description='Radius of the arc along the axis, for `crowned`. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            ge=1e-09,
            le=1000000.0,
        ),
    ] = None
    design_force: Annotated[
        float | None,
        Field(
            description='Force under which a `logarithmic` profile makes the pressure along the roller even. Range: 1e-9 to 1e9 N.',
            ge=1e-09,
            le=1000000000.0,
        ),
    ] = None
    length: Annotated[
        float,
        Field(
            description='Length that can touch, without the rounded ends. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[10.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    moment: Annotated[
        float | None,
        Field(
            description='Moment about its x axis through the middle, in place of `tilt`, which is found then: positive presses the end at positive y. It is whole from the smallest force of the job on and in proportion to the force below. Only with forces. Range: -1e12 to 1e12 N mm or -1e9 to 1e9 N m.',
            ge=-1000000000000.0,
            le=1000000000000.0,
        ),
    ] = None
    points: Annotated[
        list[Point1] | None,
        Field(
            description='Points `[y, height]` for `points`, y rising and passing 0, straight between them. Points that start or end at y = 0 are completed by their mirror image. Beyond the outermost ones the height stays.',
            max_length=10000,
            min_length=2,
        ),
    ] = None
    profile: Annotated[
        Literal['crowned', 'logarithmic', 'iso_16281', 'points'] | None,
        Field(
            description='How the surface falls towards the ends: `crowned` in an arc of `crown_radius`, `logarithmic` by Lundberg for `design_force`, `iso_16281` with the factor of that standard, `points` as given. If it is left out, the roller is straight.'
        ),
    ] = None
    radius: Annotated[
        float,
        Field(
            description='Radius. Range: 1e-6 to 1e6 mm or 1e-9 to 1e3 m.',
            examples=[5.0],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    rotation: Annotated[
        float | None,
        Field(
            description='Angle of its x from that of the contact plane, in degrees, towards y; 0 if it is left out. Without unit.',
            ge=-360.0,
            le=360.0,
        ),
    ] = None
    tilt: Annotated[
        float | None,
        Field(
            description='Misalignment in the plane of axis and normal, in mrad: positive brings the end at positive y closer to the other body; 0 if it is left out. The approach is that of the middle. Without unit.',
            ge=-50.0,
            le=50.0,
        ),
    ] = None
    type: Annotated[
        Literal['roller'], Field(description='The word that names this kind.')
    ]


class Rolling(BaseModel):
    """
    A contact that passes over its track again and again, in the direction of x: a line in plane strain, an ellipse in three dimensions.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    alternating: Annotated[
        bool | None,
        Field(
            description='Whether every second pass goes back. The friction keeps its sense to the travel. Default: `false`.'
        ),
    ] = None
    force: Annotated[
        float,
        Field(
            description='Force; on unit thickness in plane strain. Range: 1e-9 to 1e9 N/mm or 1e-6 to 1e12 N/m.',
            examples=[2000.0],
            ge=1e-09,
            le=1000000000000.0,
        ),
    ]
    friction: Annotated[
        float | None,
        Field(
            description='Traction over pressure in the whole contact, which slides. Positive where the traction on the lower body acts along the travel of the load (a slider, a braked wheel), negative for a driven wheel; the upper body has the opposite traction. Without unit. Default: `0.0`.',
            examples=[0.0],
            ge=-1.0,
            le=1.0,
        ),
    ] = None
    hardening: Annotated[
        Literal['both', 'isotropic', 'kinematic'] | None,
        Field(
            description='How a body without a backstress hardens under a load that turns round, of which its curve says nothing: by `both` rules, of which the worse decides, or by one alone. Default: `both`.'
        ),
    ] = None
    passes: Annotated[
        int | None, Field(description='Passes at most. Default: `30`.', ge=1, le=100)
    ] = None
    track: Annotated[
        float | None,
        Field(
            description='Length of the track over the elastic half-width or the semi-axis along the travel, after which the material comes back; 32 of a line and 12 in three dimensions, where it is missing. Without unit.',
            ge=8.0,
            le=256.0,
        ),
    ] = None
    until: Annotated[
        Literal['verdict', 'passes'] | None,
        Field(
            description='When to end: at the `verdict`, as soon as three passes running agree on it, or after all `passes`. Default: `verdict`.'
        ),
    ] = None


class RollingLoad(BaseModel):
    """
    A force that rolls over a track, pass after pass: what becomes of the track is the answer.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    approach: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    approaches: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    force: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    forces: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    hardness: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    history: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    onset: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    rolling: Annotated[Rolling, Field(examples=[{'force': 2000.0, 'friction': 0.2}])]
    target: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None


class SolverSettings(BaseModel):
    """
    Iteration controls.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    contact: Annotated[
        Literal['active_set', 'simplex'] | None,
        Field(
            description='The method that solves the contact conditions. Default: `active_set`.'
        ),
    ] = None
    coupling: Annotated[
        Literal['accelerated', 'strong', 'weak', 'secant_stiffness'] | None,
        Field(
            description='How the contact iteration and the plastic iteration alternate. Default: `accelerated`.'
        ),
    ] = None
    increments: Annotated[
        int | None,
        Field(
            description='Increments of each load of a history, of equal size. Without it the program chooses them. Only with `flow`.',
            ge=1,
            le=10000,
        ),
    ] = None
    max_iterations: Annotated[
        int | None,
        Field(description='Iteration limit. Default: `500`.', ge=1, le=100000),
    ] = None
    method: Annotated[
        Literal['standard', 'jiang_shang'] | None,
        Field(
            description='`jiang_shang` is their published method: deformation theory, strong coupling, contact by the simplex; `coupling` may be `weak` or `secant_stiffness` for their comparisons. Default: `standard`.'
        ),
    ] = None
    theory: Annotated[
        Literal['flow', 'deformation'] | None,
        Field(
            description='Theory of plasticity: `flow` follows the loads from rest in increments; `deformation` takes each load at once, knows no unloading, and its error has no bound. Default: `flow`.'
        ),
    ] = None
    tolerance: Annotated[
        float | None,
        Field(
            description='Relative tolerance on the displacement change and on the out-of-balance force. Without unit. Default: `1e-6`.',
            examples=[1e-06],
            ge=1e-12,
            le=0.1,
        ),
    ] = None


class HardnessLoad(BaseModel):
    """
    A hardness test of the lower body: its number is the answer.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    approach: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    approaches: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    force: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    forces: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    hardness: Annotated[
        HardnessTest | str,
        Field(
            description='The test, or its name: `HBW 10/3000`, `HV 10`, `HRC`, `HRB`.',
            examples=[{'ball': 10.0, 'force_kgf': 3000.0, 'scale': 'HBW'}],
        ),
    ]
    history: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    onset: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    rolling: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    target: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None


class HardnessOverDepth(BaseModel):
    """
    Hardness over depth, of which the yield stress follows by σ_y = 2.876 HV − 90.7 MPa.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    hardness: Annotated[
        HardnessProfile | HardenedCase,
        Field(description='Measured at points, or of a case.'),
    ]


class Swift(BaseModel):
    """
    q = σ_y (1 + ε_p/ε_0)^n.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    backstress: Annotated[
        list[BackstressTerm] | None,
        Field(description='Terms of the backstress, for flow theory.', max_length=4),
    ] = None
    exponent: Annotated[
        float,
        Field(
            description='Exponent n. Without unit.', examples=[0.2], ge=0.001, le=1.0
        ),
    ]
    law: Annotated[
        Literal['swift'], Field(description='The word that names this kind.')
    ]
    over_depth: Annotated[
        StrengthFactors | HardnessOverDepth | None,
        Field(description='How the stresses of the curve vary with the depth.'),
    ] = None
    strain_offset: Annotated[
        float,
        Field(
            description='Strain offset ε_0. Without unit.',
            examples=[0.002],
            ge=1e-09,
            le=1000.0,
        ),
    ]
    yield_stress: Annotated[
        float,
        Field(
            description='Yield stress σ_y. Range: 1e-6 to 1e7 MPa or 1e0 to 1e13 Pa.',
            examples=[500.0],
            ge=1e-06,
            le=10000000000000.0,
        ),
    ]


class Table(BaseModel):
    """
    A measured curve.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    backstress: Annotated[
        list[BackstressTerm] | None,
        Field(description='Terms of the backstress, for flow theory.', max_length=4),
    ] = None
    law: Annotated[
        Literal['table'], Field(description='The word that names this kind.')
    ]
    over_depth: Annotated[
        StrengthFactors | HardnessOverDepth | None,
        Field(description='How the stresses of the curve vary with the depth.'),
    ] = None
    points: Annotated[
        list[Point2],
        Field(
            description='Points `[plastic_strain, stress]`, joined by straight lines, constant beyond the last.',
            examples=[[[0.0, 500.0], [0.01, 600.0], [0.05, 750.0]]],
            max_length=10000,
            min_length=1,
        ),
    ]


class Voce(BaseModel):
    """
    q = σ_y + (σ_s − σ_y) (1 − exp(−b ε_p)).
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    backstress: Annotated[
        list[BackstressTerm] | None,
        Field(description='Terms of the backstress, for flow theory.', max_length=4),
    ] = None
    law: Annotated[Literal['voce'], Field(description='The word that names this kind.')]
    over_depth: Annotated[
        StrengthFactors | HardnessOverDepth | None,
        Field(description='How the stresses of the curve vary with the depth.'),
    ] = None
    rate: Annotated[
        float,
        Field(
            description='Rate b. Without unit.', examples=[50.0], ge=1e-06, le=1000000.0
        ),
    ]
    saturation_stress: Annotated[
        float,
        Field(
            description='Saturation stress σ_s, at least σ_y. Range: 1e-6 to 1e7 MPa or 1e0 to 1e13 Pa.',
            examples=[750.0],
            ge=1e-06,
            le=10000000000000.0,
        ),
    ]
    yield_stress: Annotated[
        float,
        Field(
            description='Yield stress σ_y. Range: 1e-6 to 1e7 MPa or 1e0 to 1e13 Pa.',
            examples=[500.0],
            ge=1e-06,
            le=10000000000000.0,
        ),
    ]


class Bilinear(BaseModel):
    """
    A straight line beyond the yield stress.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    backstress: Annotated[
        list[BackstressTerm] | None,
        Field(description='Terms of the backstress, for flow theory.', max_length=4),
    ] = None
    law: Annotated[
        Literal['bilinear'], Field(description='The word that names this kind.')
    ]
    over_depth: Annotated[
        StrengthFactors | HardnessOverDepth | None,
        Field(description='How the stresses of the curve vary with the depth.'),
    ] = None
    tangent_modulus: Annotated[
        float,
        Field(
            description='Slope E_t of stress over total strain beyond yield, below E; 0 is perfectly plastic. Range: 0e0 to 1e8 MPa or 0e0 to 1e14 Pa.',
            examples=[10500.0],
            ge=0.0,
            le=100000000000000.0,
        ),
    ]
    yield_stress: Annotated[
        float,
        Field(
            description='Yield stress σ_y. Range: 1e-6 to 1e7 MPa or 1e0 to 1e13 Pa.',
            examples=[500.0],
            ge=1e-06,
            le=10000000000000.0,
        ),
    ]


class Ludwik(BaseModel):
    """
    q = σ_y + k ε_p^n.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    backstress: Annotated[
        list[BackstressTerm] | None,
        Field(description='Terms of the backstress, for flow theory.', max_length=4),
    ] = None
    coefficient: Annotated[
        float,
        Field(
            description='Coefficient k. Range: 1e-6 to 1e7 MPa or 1e0 to 1e13 Pa.',
            examples=[500.0],
            ge=1e-06,
            le=10000000000000.0,
        ),
    ]
    exponent: Annotated[
        float,
        Field(
            description='Exponent n. Without unit.', examples=[0.5], ge=0.001, le=1.0
        ),
    ]
    law: Annotated[
        Literal['ludwik'], Field(description='The word that names this kind.')
    ]
    over_depth: Annotated[
        StrengthFactors | HardnessOverDepth | None,
        Field(description='How the stresses of the curve vary with the depth.'),
    ] = None
    yield_stress: Annotated[
        float,
        Field(
            description='Yield stress σ_y. Range: 1e-6 to 1e7 MPa or 1e0 to 1e13 Pa.',
            examples=[500.0],
            ge=1e-06,
            le=10000000000000.0,
        ),
    ]


class RambergOsgood(BaseModel):
    """
    ε_p = a (σ_0/E) (q/σ_0)^m.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    backstress: Annotated[
        list[BackstressTerm] | None,
        Field(description='Terms of the backstress, for flow theory.', max_length=4),
    ] = None
    exponent: Annotated[
        float,
        Field(
            description='Exponent m, from linear to, for every purpose, perfectly plastic. Without unit.',
            examples=[5.0],
            ge=1.0,
            le=200.0,
        ),
    ]
    law: Annotated[
        Literal['ramberg_osgood'], Field(description='The word that names this kind.')
    ]
    offset: Annotated[
        float,
        Field(
            description='Offset a. Without unit.',
            examples=[0.3],
            ge=1e-09,
            le=1000000.0,
        ),
    ]
    over_depth: Annotated[
        StrengthFactors | HardnessOverDepth | None,
        Field(description='How the stresses of the curve vary with the depth.'),
    ] = None
    reference_stress: Annotated[
        float,
        Field(
            description='Reference stress σ_0. Range: 1e-6 to 1e7 MPa or 1e0 to 1e13 Pa.',
            examples=[500.0],
            ge=1e-06,
            le=10000000000000.0,
        ),
    ]


class Deformable(BaseModel):
    """
    An isotropic body, elastic unless it has a hardening curve.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    fatigue: Annotated[
        GivenLimits | FatigueOfHardness | None,
        Field(
            description='Limits of high-cycle fatigue; without them nothing is said of it.'
        ),
    ] = None
    initial_stress: Annotated[
        list[InitialStress] | None,
        Field(
            description='Stress before any load, by depth: straight between depths, constant beyond the ends. It is relaxed before the load; what is left is reported.',
            max_length=1000,
            min_length=1,
        ),
    ] = None
    name: Annotated[
        str | None,
        Field(
            description='What the material is called; figures alone count.',
            max_length=80,
            min_length=1,
            pattern='^[^\\u0000-\\u001f\\u007f-\\u009f]*$',
        ),
    ] = None
    plasticity: Annotated[
        Bilinear | RambergOsgood | Table | Swift | Ludwik | Voce | None,
        Field(description='The hardening curve; a body without one stays elastic.'),
    ] = None
    poisson_ratio: Annotated[
        float,
        Field(
            description="Poisson's ratio ν. What is incompressible has 0.499999. Without unit.",
            examples=[0.3],
            ge=0.0,
            le=0.499999,
        ),
    ]
    rigid: Annotated[
        None, Field(description='Belongs to another kind of object; not given here.')
    ] = None
    young_modulus: Annotated[
        float,
        Field(
            description="Young's modulus E. Range: 1e-3 to 1e8 MPa or 1e3 to 1e14 Pa.",
            examples=[210000.0],
            ge=0.001,
            le=100000000000000.0,
        ),
    ]


class ContactBody(BaseModel):
    """
    One body, described in its own frame: the contact starts at the origin, heights are counted along the outward normal. At most one of the two is rigid.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    material: Annotated[
        Deformable | Rigid, Field(description='What a body is made of.')
    ]
    shape: Annotated[
        Cylinder | Block | Groove | Hole | Profile | Wedge | Cone | Punch | Parabola | Ellipse | Power | Sphere | Curved | Roller | Flat,
        Field(description='The undeformed outline of a body.', discriminator='type'),
    ]
    support: Annotated[
        Literal['clamped', 'roller'] | None,
        Field(description='How the far boundary is held. Default: `clamped`.'),
    ] = None
    surface: Annotated[
        SurfaceHeights | None,
        Field(
            description='Heights on top of the shape, measured or computed; only in three dimensions.'
        ),
    ] = None


class ContactJob(BaseModel):
    """
    Two bodies, what presses them together, and how to solve it. An unknown key is an error; null is the same as leaving a member out.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    analysis: Annotated[
        Literal['plane_strain', 'plane_stress', 'axisymmetric', 'three_dimensional'] | None,
        Field(
            description='Kinematics. Required, but for a hardness test, which is `axisymmetric`.'
        ),
    ] = None
    find: Annotated[
        Find | None,
        Field(description='An input that is sought for what it does to a figure.'),
    ] = None
    load: Annotated[
        ForceLoad | ForcesLoad | ApproachLoad | ApproachesLoad | HistoryLoad | OnsetLoad | TargetLoad | RollingLoad | HardnessLoad,
        Field(
            description='What presses the bodies together: exactly one of these. Several values are a sweep, one step each.'
        ),
    ]
    lower: Annotated[ContactBody, Field(description='The body below the contact.')]
    mesh: Annotated[MeshSettings | None, Field(description='The mesh.')] = None
    output: Annotated[
        OutputSettings | None, Field(description='What the result contains.')
    ] = None
    solver: Annotated[
        SolverSettings | None, Field(description='Iteration controls.')
    ] = None
    tags: Annotated[
        Tags | None,
        Field(
            description='Free labels, echoed in the result; jobs can be listed by them.'
        ),
    ] = None
    title: Annotated[
        str | None,
        Field(
            description='What the job is called.',
            max_length=80,
            min_length=1,
            pattern='^[^\\u0000-\\u001f\\u007f-\\u009f]*$',
        ),
    ] = None
    tolerances: Annotated[
        dict[str, Any] | None,
        Field(
            description='Relative tolerances of numbers of the bodies and the load by JSON pointer: the result tells what they do to every figure.',
            examples=[{'/lower/material/plasticity/yield_stress': 0.05}],
        ),
    ] = None
    units: Annotated[
        Literal['mm_N_MPa', 'SI'] | None,
        Field(
            description='Units of every figure of the job and of its result. Default: `mm_N_MPa`.'
        ),
    ] = None
    upper: Annotated[
        ContactBody | None,
        Field(
            description='The body above the contact. Required, but for a hardness test, which brings its indenter.'
        ),
    ] = None
