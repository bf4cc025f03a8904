# Generated from api/openapi.json by clients/python/scripts/models.sh; do not edit.

from __future__ import annotations

from typing import Annotated, Literal
from uuid import UUID

from pydantic import (
    AwareDatetime,
    BaseModel,
    ConfigDict,
    Field,
    RootModel,
    StringConstraints,
)
from typing_extensions import TypeAliasType


class AnswerPlace(BaseModel):
    """
    The place of an answer, in the coordinates of `contact` and `plasticity`.
    """

    body: Annotated[
        Literal['upper', 'lower', 'both'], Field(description='In which body.')
    ]
    depth: Annotated[
        float, Field(description='Depth below the surface. Unit: mm (SI: m).')
    ]
    x: Annotated[float, Field(description='x, or the radius. Unit: mm (SI: m).')]
    y: Annotated[
        float | None,
        Field(description='y; only in three dimensions. Unit: mm (SI: m).'),
    ] = None


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


class BodyErrors(BaseModel):
    """
    Estimated relative errors of figures of one body; 0 of a figure that is 0.
    """

    area: Annotated[
        float | None, Field(description='Of the plastic area. Without unit.', ge=0.0)
    ]
    depth: Annotated[
        float | None,
        Field(
            description='Of the depth by which the surface is lowered, in three dimensions by plastic strain alone. Without unit.',
            ge=0.0,
        ),
    ]
    least_stress: Annotated[
        float | None,
        Field(
            description='Of the least stress along the surface below the middle of the contact, in three dimensions below the largest pressure; without load that is the residual stress. Without unit.',
            ge=0.0,
        ),
    ]
    max_equivalent_plastic_strain: Annotated[
        float | None,
        Field(description='Of the largest plastic strain. Without unit.', ge=0.0),
    ]
    mean_equivalent_plastic_strain: Annotated[
        float | None,
        Field(description='Of the mean plastic strain. Without unit.', ge=0.0),
    ]
    pile_up: Annotated[
        float | None,
        Field(description='Of the height by which it is raised. Without unit.', ge=0.0),
    ]
    utilization: Annotated[
        float | None,
        Field(
            description='Of the largest von Mises stress there over the yield stress. Without unit.',
            ge=0.0,
        ),
    ]


class BodyErrorsOfBodies(BaseModel):
    """
    One value for each body.
    """

    lower: Annotated[
        BodyErrors | None,
        Field(
            description='Of the lower body; null if it is rigid or the step was stopped.'
        ),
    ]
    upper: Annotated[
        BodyErrors | None,
        Field(
            description='Of the upper body; null if it is rigid or the step was stopped.'
        ),
    ]


class BodyPass(BaseModel):
    """
    What a pass leaves in a body.
    """

    accumulated_strain: Annotated[
        float,
        Field(
            description='Largest plastic strain that all passes so far have accumulated. Without unit.',
            ge=0.0,
        ),
    ]
    forward: Annotated[
        float,
        Field(
            description='How far this pass has moved the surface along the travel, against the depth. Unit: mm (SI: m).'
        ),
    ]
    groove_depth: Annotated[
        float,
        Field(
            description='How far the surface has sunk in all passes, on the axis of the track. Unit: mm (SI: m).'
        ),
    ]
    largest_sigma_x: Annotated[
        float,
        Field(
            description='Largest residual stress along the travel. Unit: MPa (SI: Pa).'
        ),
    ]
    largest_sigma_z: Annotated[
        float,
        Field(
            description='Largest residual stress across the travel. Unit: MPa (SI: Pa).'
        ),
    ]
    largest_strain: Annotated[
        float,
        Field(
            description='Largest plastic strain that the pass has accumulated. Without unit.',
            ge=0.0,
        ),
    ]
    largest_strain_across: Annotated[
        float,
        Field(
            description='Its distance from the axis of the track; 0 of a line. Unit: mm (SI: m).',
            ge=0.0,
        ),
    ]
    largest_strain_depth: Annotated[
        float, Field(description='Its depth. Unit: mm (SI: m).', ge=0.0)
    ]
    least_sigma_x: Annotated[
        float,
        Field(
            description='Least residual stress along the travel. Unit: MPa (SI: Pa).'
        ),
    ]
    least_sigma_z: Annotated[
        float,
        Field(
            description='Least residual stress across the travel. Unit: MPa (SI: Pa).'
        ),
    ]
    net_strain: Annotated[
        float,
        Field(
            description='Largest change of the plastic strain by the pass, as an equivalent strain: what a cycle that closes takes back is not in it. Without unit.',
            ge=0.0,
        ),
    ]
    net_strain_across: Annotated[
        float,
        Field(
            description='Its distance from the axis of the track; 0 of a line. Unit: mm (SI: m).',
            ge=0.0,
        ),
    ]
    net_strain_depth: Annotated[
        float, Field(description='Its depth. Unit: mm (SI: m).', ge=0.0)
    ]
    pile_up: Annotated[
        float,
        Field(
            description='How far it has risen beside the groove; 0 of a line. Unit: mm (SI: m).',
            ge=0.0,
        ),
    ]


class BodyPassErrors(BaseModel):
    """
    Estimated relative errors of what a pass leaves in a body; `null` of a figure that is 0.
    """

    forward: Annotated[
        float | None,
        Field(description='Of the forward displacement. Without unit.', ge=0.0),
    ]
    groove_depth: Annotated[
        float | None,
        Field(description='Of the depth of the groove. Without unit.', ge=0.0),
    ]
    largest_strain: Annotated[
        float | None,
        Field(
            description='Of the largest accumulated plastic strain. Without unit.',
            ge=0.0,
        ),
    ]
    net_strain: Annotated[
        float | None,
        Field(description='Of the largest net strain. Without unit.', ge=0.0),
    ]
    residual: Annotated[
        float | None,
        Field(
            description='Of the residual stresses, relative to the largest of them. Without unit.',
            ge=0.0,
        ),
    ]


class BodyPassErrorsOfBodies(BaseModel):
    """
    One value for each body.
    """

    lower: Annotated[
        BodyPassErrors | None,
        Field(
            description='Of the lower body; null if it is rigid or the step was stopped.'
        ),
    ]
    upper: Annotated[
        BodyPassErrors | None,
        Field(
            description='Of the upper body; null if it is rigid or the step was stopped.'
        ),
    ]


class BodyPassOfBodies(BaseModel):
    """
    One value for each body.
    """

    lower: Annotated[
        BodyPass | None,
        Field(
            description='Of the lower body; null if it is rigid or the step was stopped.'
        ),
    ]
    upper: Annotated[
        BodyPass | None,
        Field(
            description='Of the upper body; null if it is rigid or the step was stopped.'
        ),
    ]


class ClosedFormStep(BaseModel):
    """
    Hertz's contact under one force.
    """

    force: Annotated[
        float,
        Field(
            description='The force. Unit: N/mm (SI: N/m); N in axisymmetry and three dimensions.',
            examples=[612.6106],
            ge=0.0,
        ),
    ]
    half_width: Annotated[
        float,
        Field(
            description='Half-width of the strip, radius of the circle or shorter semi-axis of the ellipse. Unit: mm (SI: m).',
            examples=[0.26],
            ge=0.0,
        ),
    ]
    peak_pressure: Annotated[
        float,
        Field(
            description='Peak pressure. Unit: MPa (SI: Pa).', examples=[1500.0], ge=0.0
        ),
    ]
    yields: Annotated[
        bool,
        Field(
            description="Whether a body yields under this force: then Hertz's figures no longer hold."
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


class ContactMaps(BaseModel):
    """
    Cells of the surface. The cell at `x[i]`, `y[j]` stands at the place `i * y.length + j` of a map, counted from 0.
    """

    dent: Annotated[
        list[float] | None,
        Field(
            description='How far plastic strain lowers both surfaces together, without force the dents of both; absent where no body has a hardening curve. Unit: mm (SI: m).'
        ),
    ] = None
    gap: Annotated[
        list[float], Field(description='Gap after loading. Unit: mm (SI: m).')
    ]
    pressure: Annotated[
        list[float], Field(description='Contact pressure. Unit: MPa (SI: Pa).')
    ]
    x: Annotated[
        list[float],
        Field(description='Middles of the cells along x. Unit: mm (SI: m).'),
    ]
    y: Annotated[
        list[float],
        Field(description='Middles of the cells along y. Unit: mm (SI: m).'),
    ]


class ContactNodes(BaseModel):
    """
    Values at the candidate pairs.
    """

    force: Annotated[
        list[float],
        Field(
            description='Nodal force along the normal. Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions.'
        ),
    ]
    gap: Annotated[
        list[float], Field(description='Gap after loading. Unit: mm (SI: m).')
    ]
    pressure: Annotated[
        list[float], Field(description='Contact pressure. Unit: MPa (SI: Pa).')
    ]
    x: Annotated[
        list[float],
        Field(
            description='Tangential position, along the arc for a pin in a hole. Unit: mm (SI: m).'
        ),
    ]


class ContactSection(BaseModel):
    """
    Cells along y, the mean of the two rows beside x = 0.
    """

    gap: Annotated[
        list[float], Field(description='Gap after loading. Unit: mm (SI: m).')
    ]
    pressure: Annotated[
        list[float], Field(description='Contact pressure. Unit: MPa (SI: Pa).')
    ]
    y: Annotated[
        list[float], Field(description='Middle of the cell. Unit: mm (SI: m).')
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
    Half a cylinder, a sphere in axisymmetry, held at its diametral plane.
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


class EllipseErrors(BaseModel):
    """
    Estimated relative errors of figures of the contact and of each body.
    """

    area: Annotated[float, Field(description='Of the area. Without unit.', ge=0.0)]
    b: Annotated[
        float | None,
        Field(
            description='Of the longer semi-axis; `null` of heights, whose outermost cells in contact tell it. Without unit.',
            ge=0.0,
        ),
    ]
    bodies: Annotated[
        BodyErrorsOfBodies, Field(description='Of each body; `null` of a rigid one.')
    ]


class EllipticHertz(BaseModel):
    """
    Hertz's ellipse.
    """

    a: Annotated[
        float, Field(description='Shorter semi-axis. Unit: mm (SI: m).', ge=0.0)
    ]
    approach: Annotated[
        float,
        Field(
            description='Approach of points far from the contact. Unit: mm (SI: m).',
            ge=0.0,
        ),
    ]
    b: Annotated[
        float, Field(description='Longer semi-axis. Unit: mm (SI: m).', ge=0.0)
    ]


class Energy(BaseModel):
    """
    Energies of both bodies: force times length.
    """

    dissipated: Annotated[
        float,
        Field(
            description='The rest of it. Unit: N (SI: N) of thickness, force times length; N mm (SI: J) in axisymmetry and three dimensions.',
            ge=0.0,
        ),
    ]
    elastic: Annotated[
        float,
        Field(
            description='Elastic energy. Unit: N (SI: N) of thickness, force times length; N mm (SI: J) in axisymmetry and three dimensions.',
            ge=0.0,
        ),
    ]
    plastic: Annotated[
        float,
        Field(
            description='Work of the stresses on plastic strain. Unit: N (SI: N) of thickness, force times length; N mm (SI: J) in axisymmetry and three dimensions.',
            ge=0.0,
        ),
    ]
    stored: Annotated[
        float,
        Field(
            description='The part of that which the backstress stores. Unit: N (SI: N) of thickness, force times length; N mm (SI: J) in axisymmetry and three dimensions.',
            ge=0.0,
        ),
    ]
    work: Annotated[
        float,
        Field(
            description='Work of the contact force, the sum of the next two. Unit: N (SI: N) of thickness, force times length; N mm (SI: J) in axisymmetry and three dimensions.',
            ge=0.0,
        ),
    ]


class ErrorEstimate(BaseModel):
    """
    Estimated bounds of the relative discretization errors. They hold in at least 95 of 100 cases and say nothing about the theory: for that see `validity`, which also says why a bound is `null`.
    """

    approach: Annotated[
        float | None,
        Field(
            description='Of the approach; 0 where it is prescribed. Without unit.',
            ge=0.0,
        ),
    ]
    bodies: Annotated[
        BodyErrorsOfBodies | None,
        Field(
            description='Of figures of each body; absent in three dimensions, which have their own.'
        ),
    ] = None
    contact_stiffness: Annotated[
        float | None,
        Field(
            description='Of the contact stiffness, where there is one. Without unit.',
            ge=0.0,
        ),
    ]
    force: Annotated[
        float | None,
        Field(
            description='Of the contact force; 0 where it is prescribed. Without unit.',
            ge=0.0,
        ),
    ]
    half_width: Annotated[
        float | None, Field(description='Of the half-width. Without unit.', ge=0.0)
    ]
    middle_pressure: Annotated[
        float | None,
        Field(
            description='Of the pressure in the middle of the contact. Without unit.',
            ge=0.0,
        ),
    ]
    peak_pressure: Annotated[
        float | None, Field(description='Of the peak pressure. Without unit.', ge=0.0)
    ]


class Estimate(BaseModel):
    """
    What a job will cost.
    """

    bytes: Annotated[
        int,
        Field(
            description='Peak memory, the fields of a step while they are handed over included. Unit: byte.',
            ge=0,
        ),
    ]
    equations: Annotated[int, Field(description='Equations of both bodies.', ge=0)]
    result_bytes: Annotated[
        int,
        Field(description='The result of all steps as it is kept. Unit: byte.', ge=0),
    ]


class Fault(BaseModel):
    """
    One fault in a job or in a query string.
    """

    code: Annotated[
        str,
        Field(
            description='The kind of fault, for programs. There may be more in the future.',
            examples=['required', 'unknown_key', 'duplicate_key', 'wrong_type', 'out_of_range', 'unknown_word', 'wrong_length', 'inconsistent', 'not_solvable', 'more_faults'],
        ),
    ]
    detail: Annotated[
        str,
        Field(
            description='What is wrong and what would be right.',
            examples=['must be between 0 and 0.499999, got 0.5'],
        ),
    ]
    parameter: Annotated[
        str | None,
        Field(description='Name of the query parameter.', examples=['limit']),
    ] = None
    pointer: Annotated[
        str | None,
        Field(
            description='JSON pointer of the field as a URI fragment (RFC 6901, section 6); `#` is the whole job.',
            examples=['#/upper/material/poisson_ratio'],
            pattern='^#(/.*)?$',
        ),
    ] = None


class DisplacementItem(RootModel[list[float]]):
    root: Annotated[list[float], Field(max_length=2, min_length=2)]


class ElementItem(RootModel[int]):
    root: Annotated[int, Field(ge=0)]


class Element(RootModel[list[ElementItem]]):
    root: Annotated[list[ElementItem], Field(max_length=4, min_length=4)]


class Node(RootModel[list[float]]):
    root: Annotated[list[float], Field(max_length=2, min_length=2)]


class Fields(BaseModel):
    """
    Mesh and nodal fields of one body as it was meshed: one half where `mesh.symmetric` is true. Positions are those before loading, where the bodies just touch; `y` points from the lower body to the upper one.
    """

    displacement: Annotated[
        list[DisplacementItem],
        Field(
            description='Displacements `[u_x, u_y]`, each body relative to its own support. Unit: mm (SI: m).'
        ),
    ]
    elements: Annotated[
        list[Element],
        Field(
            description='Corners of each element, counter-clockwise, counted from 0.'
        ),
    ]
    equivalent_plastic_strain: Annotated[
        list[float], Field(description='Equivalent plastic strain. Without unit.')
    ]
    nodes: Annotated[list[Node], Field(description='Nodes `[x, y]`. Unit: mm (SI: m).')]
    sigma_x: Annotated[
        list[float],
        Field(description='Stress along x, or along the radius. Unit: MPa (SI: Pa).'),
    ]
    sigma_y: Annotated[
        list[float], Field(description='Stress along y. Unit: MPa (SI: Pa).')
    ]
    sigma_z: Annotated[
        list[float],
        Field(description='Out-of-plane stress, or hoop stress. Unit: MPa (SI: Pa).'),
    ]
    tau_xy: Annotated[
        list[float], Field(description='Shear stress. Unit: MPa (SI: Pa).')
    ]
    von_mises: Annotated[
        list[float], Field(description='Von Mises stress. Unit: MPa (SI: Pa).')
    ]


class FieldsOfBodies(BaseModel):
    """
    One value for each body.
    """

    lower: Annotated[
        Fields | None,
        Field(
            description='Of the lower body; null if it is rigid or the step was stopped.'
        ),
    ]
    upper: Annotated[
        Fields | None,
        Field(
            description='Of the upper body; null if it is rigid or the step was stopped.'
        ),
    ]


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


class FrictionLimits(BaseModel):
    """
    Elastic peak pressures that a track bears under a friction.
    """

    elastic_pressure: Annotated[
        float,
        Field(
            description="Hertz's peak pressure up to which nothing yields. Unit: MPa (SI: Pa).",
            ge=0.0,
        ),
    ]
    friction: Annotated[
        float,
        Field(
            description='Traction over pressure in the whole contact. Without unit.',
            ge=0.0,
        ),
    ]
    kinematic_pressure: Annotated[
        float,
        Field(
            description='The same up to which bodies with kinematic hardening without bound shake down. Unit: MPa (SI: Pa).',
            ge=0.0,
        ),
    ]
    perfect_pressure: Annotated[
        float | None,
        Field(
            description='The same up to which perfectly plastic bodies shake down; `null` of an ellipse that slides. Unit: MPa (SI: Pa).',
            ge=0.0,
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


class Health(BaseModel):
    """
    How the service is.
    """

    status: Annotated[str, Field(description='In a word.', examples=['ready'])]


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


class IncrementNumber(BaseModel):
    """
    Where a history of loads is. All numbers are one-based.
    """

    count: Annotated[int, Field(description='Increments of that load.', ge=0)]
    load: Annotated[int, Field(description='Number of the load.', ge=0)]
    loads: Annotated[int, Field(description='Loads of the history.', ge=0)]
    number: Annotated[
        int, Field(description='Number of the increment within its load.', ge=0)
    ]


class Iteration(RootModel[int]):
    root: Annotated[int, Field(ge=0)]


class Increments(BaseModel):
    """
    The ends of the increments, in order.
    """

    approach: Annotated[list[float], Field(description='Approach. Unit: mm (SI: m).')]
    force: Annotated[
        list[float],
        Field(
            description='Contact force. Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions.'
        ),
    ]
    half_width: Annotated[
        list[float], Field(description='Half-width. Unit: mm (SI: m).')
    ]
    iterations: Annotated[list[Iteration], Field(description='Iterations made.')]
    peak_pressure: Annotated[
        list[float], Field(description='Largest pressure. Unit: MPa (SI: Pa).')
    ]


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


class Iteration1(BaseModel):
    """
    One outer iteration. Counts are of this iteration alone.
    """

    approach: Annotated[float, Field(description='Approach α. Unit: mm (SI: m).')]
    contact_pairs: Annotated[int, Field(description='Pairs in contact.', ge=0)]
    contact_pivots: Annotated[
        int,
        Field(
            description='Simplex pivots, or active-set changes, of the contact solve.',
            ge=0,
        ),
    ]
    displacement_change: Annotated[
        float,
        Field(
            description="`‖u - u_previous‖ / ‖u‖`, the paper's criterion. Without unit.",
            ge=0.0,
        ),
    ]
    elapsed_ms: Annotated[
        float, Field(description='Since the start of the job. Unit: ms.', ge=0.0)
    ]
    equilibrium_residual: Annotated[
        float,
        Field(
            description='`‖∫Bᵀσ dV - R‖ / ‖R‖` over the free degrees of freedom. Without unit.',
            ge=0.0,
        ),
    ]
    factorizations: Annotated[int, Field(description='Stiffness factorizations.', ge=0)]
    force_change: Annotated[
        float, Field(description='`‖R - R_previous‖ / ‖R‖`. Without unit.', ge=0.0)
    ]
    increment: Annotated[
        IncrementNumber | None,
        Field(
            description='The increment of a history to which the iteration belongs; absent where loads are not divided.'
        ),
    ] = None
    initial_stress_updates: Annotated[
        int,
        Field(
            description='Initial-stress loads, or sets of secant moduli, put into effect.',
            ge=0,
        ),
    ]
    iteration: Annotated[int, Field(description='One-based.', ge=0)]
    peak_pressure: Annotated[
        float,
        Field(description='Largest contact pressure. Unit: MPa (SI: Pa).', ge=0.0),
    ]
    plastic_points: Annotated[
        int, Field(description='Gauss points beyond yield, both bodies.', ge=0)
    ]


class Layers(BaseModel):
    """
    Cells of the layers of one body. The cell at `x[i]`, `y[j]`, `z[k]` stands at the place `(k * x.length + i) * y.length + j` of an array, counted from 0. Axes are those of the contact: x along its shorter semi-axis, y along the longer one, z into the body. Of a load that rolls they are the section of the track behind it: x, of one cell, along the travel, y across it.
    """

    equivalent_plastic_strain: Annotated[
        list[float], Field(description='Equivalent plastic strain. Without unit.')
    ]
    plastic_strain_xx: Annotated[
        list[float],
        Field(
            description='Plastic strain along x; 0 in a body that does not yield, like the following. Without unit.'
        ),
    ]
    plastic_strain_xy: Annotated[
        list[float],
        Field(
            description='Plastic shear strain of x and y, half of the change of the angle; so are the following. Without unit.'
        ),
    ]
    plastic_strain_xz: Annotated[
        list[float], Field(description='Plastic shear strain of x and z. Without unit.')
    ]
    plastic_strain_yy: Annotated[
        list[float], Field(description='Plastic strain along y. Without unit.')
    ]
    plastic_strain_yz: Annotated[
        list[float], Field(description='Plastic shear strain of y and z. Without unit.')
    ]
    plastic_strain_zz: Annotated[
        list[float], Field(description='Plastic strain along the normal. Without unit.')
    ]
    sigma_xx: Annotated[
        list[float],
        Field(
            description='Stress along x, initial stress included. Unit: MPa (SI: Pa).'
        ),
    ]
    sigma_xy: Annotated[
        list[float], Field(description='Shear stress of x and y. Unit: MPa (SI: Pa).')
    ]
    sigma_xz: Annotated[
        list[float], Field(description='Shear stress of x and z. Unit: MPa (SI: Pa).')
    ]
    sigma_yy: Annotated[
        list[float],
        Field(
            description='Stress along y, initial stress included. Unit: MPa (SI: Pa).'
        ),
    ]
    sigma_yz: Annotated[
        list[float], Field(description='Shear stress of y and z. Unit: MPa (SI: Pa).')
    ]
    sigma_zz: Annotated[
        list[float], Field(description='Normal stress. Unit: MPa (SI: Pa).')
    ]
    von_mises: Annotated[
        list[float], Field(description='Von Mises stress. Unit: MPa (SI: Pa).')
    ]
    x: Annotated[
        list[float],
        Field(description='Middles of the cells along x. Unit: mm (SI: m).'),
    ]
    y: Annotated[
        list[float],
        Field(description='Middles of the cells along y. Unit: mm (SI: m).'),
    ]
    z: Annotated[
        list[float], Field(description='Middles of the layers. Unit: mm (SI: m).')
    ]
    z_faces: Annotated[
        list[float],
        Field(
            description='Faces of the layers, from the surface down; one more than layers. Unit: mm (SI: m).'
        ),
    ]


class LayersOfBodies(BaseModel):
    """
    One value for each body.
    """

    lower: Annotated[
        Layers | None,
        Field(
            description='Of the lower body; null if it is rigid or the step was stopped.'
        ),
    ]
    upper: Annotated[
        Layers | None,
        Field(
            description='Of the upper body; null if it is rigid or the step was stopped.'
        ),
    ]


class Limits(BaseModel):
    """
    Bounds on single requests.
    """

    batch_jobs: Annotated[
        int,
        Field(
            description='Most jobs in one request to `/v1/batch`.', examples=[100], ge=0
        ),
    ]
    body_bytes: Annotated[
        int, Field(description='Largest body. Unit: byte.', examples=[1048576], ge=0)
    ]
    job_memory_bytes: Annotated[
        int, Field(description='Largest estimated memory of a job. Unit: byte.', ge=0)
    ]
    job_seconds: Annotated[
        float,
        Field(description='Longest time \\[s\\] a job is solved for.', examples=[600]),
    ]
    result_bytes: Annotated[
        int, Field(description='Largest estimated result of a job. Unit: byte.', ge=0)
    ]
    solve_seconds: Annotated[
        float,
        Field(
            description='Longest time \\[s\\] `POST /v1/solve` waits for its result.',
            examples=[30],
        ),
    ]
    wait_seconds: Annotated[
        float,
        Field(
            description='Longest time \\[s\\] `?wait=` and `Prefer: wait` wait.',
            examples=[60],
        ),
    ]


class Links(BaseModel):
    """
    Addresses that belong to a job: those that answer in its present state.
    """

    cancel: Annotated[
        str | None, Field(description='Where to POST to stop it; until it is done.')
    ] = None
    depth_svg: Annotated[
        str | None,
        Field(description='Stresses over depth, drawn; where the job asks for them.'),
    ] = None
    events: Annotated[str, Field(description='Its events as they happen.')]
    field_vtr: Annotated[
        str | None,
        Field(
            description='Layers of half-spaces for ParaView, of a track its section; where a job in three dimensions asks for fields.'
        ),
    ] = None
    field_vtu: Annotated[
        str | None,
        Field(description='Mesh and fields for ParaView; where the job asks for them.'),
    ] = None
    hardness_csv: Annotated[
        str | None, Field(description='The load-displacement curve of a hardness test.')
    ] = None
    increments_csv: Annotated[
        str | None,
        Field(
            description='The increments of all loads; by flow theory. So are the following.'
        ),
    ] = None
    load_approach_svg: Annotated[
        str | None,
        Field(
            description='Force over approach, drawn; where all of several loads have converged.'
        ),
    ] = None
    passes_csv: Annotated[
        str | None, Field(description='The passes of a load that rolls.')
    ] = None
    pressure_csv: Annotated[
        str | None, Field(description='Contact pressure of all steps.')
    ] = None
    pressure_svg: Annotated[
        str | None, Field(description='Contact pressure, drawn.')
    ] = None
    request: Annotated[str, Field(description='What was submitted.')]
    result: Annotated[
        str | None,
        Field(description='Its result; as soon as it has one. So are the following.'),
    ] = None
    self: Annotated[
        str,
        Field(
            description='The job itself.',
            examples=['/v1/jobs/0197e1f0-0000-7000-8000-000000000000'],
        ),
    ]
    subsurface_csv: Annotated[
        str | None,
        Field(
            description='Stresses over depth; where the job asks for them. In a list of jobs this and the following are left out.'
        ),
    ] = None
    summary_csv: Annotated[
        str | None, Field(description='One row of figures for each step.')
    ] = None
    surface_csv: Annotated[
        str | None, Field(description='The surfaces of both bodies after every load.')
    ] = None
    surface_svg: Annotated[
        str | None, Field(description='The surfaces of both bodies, drawn.')
    ] = None


class LoadApproach(BaseModel):
    """
    Force over approach, only of converged steps: in order of the approach or, of a history, in the order of the increments with the bodies at rest before them.
    """

    approach: Annotated[list[float], Field(description='Approach α. Unit: mm (SI: m).')]
    force: Annotated[
        list[float],
        Field(
            description='Contact force P. Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions.'
        ),
    ]
    stiffness: Annotated[
        list[float],
        Field(
            description='dP/dα along this curve: the contact stiffness of a step that has one, else the difference between two points of the curve. Unit: N/mm² (SI: N/m²); in axisymmetry and three dimensions N/mm (SI: N/m).'
        ),
    ]
    stiffness_from: Annotated[
        list[float] | None,
        Field(
            description='Force from which on each slope was taken, that of the point itself where the contact stiffness of the step is known. Up to `stiffness_to` the contact grows by two elements or more, where the curve is long enough. Empty before version 0.3. Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions.'
        ),
    ] = None
    stiffness_to: Annotated[
        list[float] | None,
        Field(
            description='Force up to which it was taken. Empty before version 0.3. Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions.'
        ),
    ] = None


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


class Mesh(BaseModel):
    """
    The mesh that was solved on.
    """

    contact_pairs: Annotated[
        int, Field(description='Candidate node pairs of the meshed part.', ge=0)
    ]
    elements: Annotated[int, Field(description='Elements of both bodies.', ge=0)]
    enlargements: Annotated[
        int,
        Field(
            description='Times the mesh was enlarged because the contact reached its edge.',
            ge=0,
        ),
    ]
    equations: Annotated[int, Field(description='Equations of both bodies.', ge=0)]
    max_aspect_ratio: Annotated[
        float,
        Field(
            description='Largest ratio of element side lengths. Without unit.', ge=0.0
        ),
    ]
    min_jacobian_ratio: Annotated[
        float,
        Field(
            description='Smallest ratio of Jacobian determinants within one element; 1 is a parallelogram. Without unit.'
        ),
    ]
    nodes: Annotated[int, Field(description='Nodes of both bodies.', ge=0)]
    passes: Annotated[
        int, Field(description='Mesh passes made, the sizing ones included.', ge=0)
    ]
    spacing: Annotated[
        float,
        Field(
            description='Tangential spacing in the contact. Unit: mm (SI: m).', ge=0.0
        ),
    ]
    symmetric: Annotated[
        bool, Field(description='Whether one half stands for both by symmetry.')
    ]


class MeshSettings(BaseModel):
    """
    The mesh.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
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


class OliverPharr(BaseModel):
    """
    Oliver and Pharr's figures (J. Mater. Res. 7 (1992) 1564) of the unloading curve, beside the true contact.
    """

    area: Annotated[
        float,
        Field(description='Area of the indenter at this depth. Unit: mm² (SI: m²).'),
    ]
    contact_depth: Annotated[
        float,
        Field(description='Contact depth `h_c = h − 0.75 F/S`. Unit: mm (SI: m).'),
    ]
    hardness_error: Annotated[
        float | None,
        Field(
            description='Estimated bound of its relative error by the mesh. Without unit.',
            ge=0.0,
        ),
    ]
    indentation_hardness: Annotated[
        float, Field(description='Force over the area, H. Unit: MPa (SI: Pa).')
    ]
    modulus_error: Annotated[
        float | None,
        Field(
            description='Estimated bound of its relative error by the mesh. Without unit.',
            ge=0.0,
        ),
    ]
    reduced_modulus: Annotated[
        float, Field(description='`√π S / (2 √A)`. Unit: MPa (SI: Pa).')
    ]
    stiffness: Annotated[
        float,
        Field(
            description='Slope S of the unloading curve at its beginning. Unit: N/mm² (SI: N/m²); in axisymmetry and three dimensions N/mm (SI: N/m).'
        ),
    ]
    true_area: Annotated[
        float, Field(description='Area of the true contact. Unit: mm² (SI: m²).')
    ]
    true_reduced_modulus: Annotated[
        float, Field(description='E* of the two materials. Unit: MPa (SI: Pa).')
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


class PassErrors(BaseModel):
    """
    Estimated relative errors of a pass; `null` of a figure that is 0.
    """

    approach: Annotated[
        float | None,
        Field(description='Of the approach; `null` of a line. Without unit.', ge=0.0),
    ]
    bodies: Annotated[
        BodyPassErrorsOfBodies, Field(description='Of the figures of each body.')
    ]
    half_width: Annotated[
        float | None, Field(description='Of the half-width. Without unit.', ge=0.0)
    ]
    peak_pressure: Annotated[
        float | None, Field(description='Of the peak pressure. Without unit.', ge=0.0)
    ]
    plastic_work: Annotated[
        float | None,
        Field(
            description='Of the plastic work, and of rolling force and loss. Without unit.',
            ge=0.0,
        ),
    ]


class Patch(BaseModel):
    """
    One connected part of the contact. The outer ends of all are interpolated to where the pressure vanishes, those between two parts are loaded nodes. Of a body of revolution they are radii.
    """

    left: Annotated[float, Field(description='Left end. Unit: mm (SI: m).')]
    right: Annotated[float, Field(description='Right end. Unit: mm (SI: m).')]


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


class OutlineItem(RootModel[list[float]]):
    root: Annotated[list[float], Field(max_length=2, min_length=2)]


class PlasticZone(BaseModel):
    """
    Extent of plastic flow in one body.
    """

    area: Annotated[
        float,
        Field(
            description='Area of the plastic zone in the section x–y, both sides of the axis; summed over the Gauss points. Unit: mm² (SI: m²).',
            ge=0.0,
        ),
    ]
    depth: Annotated[float, Field(description='Depth of that point. Unit: mm (SI: m).')]
    max_equivalent_plastic_strain: Annotated[
        float | None,
        Field(
            description='Largest equivalent plastic strain at a Gauss point; `null` of a material that does not harden, where it has no limit on smaller and smaller elements. Without unit.',
            ge=0.0,
        ),
    ]
    mean_equivalent_plastic_strain: Annotated[
        float | None,
        Field(
            description='Mean equivalent plastic strain over the area of the section that has yielded. Without unit.',
            ge=0.0,
        ),
    ] = None
    outline: Annotated[
        list[list[OutlineItem]],
        Field(
            description='Outline of the plastic zone: closed polygons of points `[x, depth]`, the first one not repeated, both sides of the axis. Depth is counted downward from the plane in which the bodies first touch, into the material of either body. Counter-clockwise in the axes `(x, depth)`; holes clockwise. Unit: mm (SI: m).'
        ),
    ]
    position: Annotated[float, Field(description='x of that point. Unit: mm (SI: m).')]
    position_y: Annotated[
        float | None,
        Field(
            description='y of the point with the largest plastic strain; of this and the next only in three dimensions, where there is no outline and `area` is that of the cells beside y = 0. Unit: mm (SI: m).'
        ),
    ] = None
    reached_surface: Annotated[
        bool,
        Field(
            description='Whether the plastic zone includes a part of the free surface.'
        ),
    ]
    volume: Annotated[
        float | None,
        Field(
            description='Volume of the cells that have yielded. Unit: mm³ (SI: m³).',
            ge=0.0,
        ),
    ] = None
    yielded: Annotated[
        bool, Field(description='Whether any Gauss point is beyond yield.')
    ]


class PlasticZoneOfBodies(BaseModel):
    """
    One value for each body.
    """

    lower: Annotated[
        PlasticZone | None,
        Field(
            description='Of the lower body; null if it is rigid or the step was stopped.'
        ),
    ]
    upper: Annotated[
        PlasticZone | None,
        Field(
            description='Of the upper body; null if it is rigid or the step was stopped.'
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


class Problem(BaseModel):
    """
    An error (RFC 9457).
    """

    column: Annotated[
        int | None, Field(description='Column in that line (`invalid-json`).', ge=0)
    ] = None
    detail: Annotated[
        str, Field(description='About this occurrence.', examples=['3 fields at fault'])
    ]
    errors: Annotated[
        list[Fault] | None,
        Field(
            description='Every fault, in the order of the document or of the query string.'
        ),
    ] = None
    estimate: Annotated[
        Estimate | None, Field(description='What the job would cost (`job-too-large`).')
    ] = None
    instance: Annotated[
        str | None,
        Field(
            description='This occurrence, by the id of its request as `X-Request-Id` has it: what to name to those who run the service.',
            examples=['/requests/7d5bf0b5-4d4e-4c3a-8f0e-0b8f7a1f4c55'],
        ),
    ] = None
    limit_bytes: Annotated[
        int | None,
        Field(
            description='The limit (`body-too-large`, `job-too-large`). Unit: byte.',
            ge=0,
        ),
    ] = None
    line: Annotated[
        int | None,
        Field(
            description='Line of the body at which the JSON ends, from 1 (`invalid-json`).',
            ge=0,
        ),
    ] = None
    quota: Annotated[
        str | None,
        Field(
            description='Which quota of the API key is used up (`quota-exceeded`). There may be more in the future.',
            examples=['queued_jobs', 'stored_bytes', 'priority'],
        ),
    ] = None
    status: Annotated[
        int,
        Field(
            description="The HTTP status; of a job's `error`, the one that `POST /v1/solve` would have answered with.",
            examples=[422],
            ge=400,
            le=599,
        ),
    ]
    title: Annotated[
        str,
        Field(
            description='The kind in words, the same for every occurrence.',
            examples=['The job is not valid'],
        ),
    ]
    type: Annotated[
        str,
        Field(
            description='The kind of error: a relative address that this service answers with an explanation. There may be more in the future.',
            examples=['/problems/invalid-json', '/problems/invalid-query', '/problems/invalid-header', '/problems/invalid-job', '/problems/invalid-batch', '/problems/job-too-large', '/problems/unauthorized', '/problems/forbidden', '/problems/unknown-host', '/problems/not-found', '/problems/job-not-found', '/problems/step-not-found', '/problems/method-not-allowed', '/problems/body-timeout', '/problems/job-unfinished', '/problems/no-result', '/problems/not-in-result', '/problems/head-too-large', '/problems/body-too-large', '/problems/unsupported-media-type', '/problems/idempotency-key-reused', '/problems/queue-full', '/problems/too-many-jobs', '/problems/quota-exceeded', '/problems/too-many-streams', '/problems/too-many-bodies', '/problems/solve-failed', '/problems/internal', '/problems/store-unavailable', '/problems/damaged-record', '/problems/insufficient-storage', '/problems/shutting-down'],
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


class Progress(BaseModel):
    """
    How far a job has come.
    """

    iterations: Annotated[int, Field(description='Iterations made.', ge=0)]
    latest: Iteration1 | None


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


class Queue(BaseModel):
    """
    The queue.
    """

    capacity: Annotated[
        int, Field(description='Most jobs that may wait.', examples=[10000], ge=0)
    ]
    queued: Annotated[int, Field(description='Jobs waiting.', ge=0)]
    running: Annotated[int, Field(description='Jobs being solved.', ge=0)]


class Rigid(BaseModel):
    """
    A body that does not deform.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
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


class RollerContact(BaseModel):
    """
    The contact along a roller, in rows of cells across it. y is that of the fields, 0 in the middle of the roller.
    """

    end_pressure: Annotated[
        list[float],
        Field(
            description='Largest pressure of a cell in the outermost rows, at negative and at positive y; 0 where the contact ends before. Where the roller has sharp ends it grows without bound with finer cells. Unit: MPa (SI: Pa).'
        ),
    ]
    half_width: Annotated[
        list[float],
        Field(
            description='Half the width of the contact in each row. Unit: mm (SI: m).'
        ),
    ]
    line_load: Annotated[
        list[float],
        Field(
            description='Force on unit length of each row. Unit: N/mm² (SI: N/m²); in axisymmetry and three dimensions N/mm (SI: N/m).'
        ),
    ]
    middle_pressure: Annotated[
        float,
        Field(
            description='Largest pressure of a cell in the rows beside the middle of the roller. Unit: MPa (SI: Pa).',
            ge=0.0,
        ),
    ]
    moment: Annotated[
        float,
        Field(
            description='Moment of the pressure about the x axis through the middle, the sum of force times y: positive where the half at positive y bears more. The body whose end at positive y is pressed is held in its tilt by this moment. Unit: N (SI: N) of thickness, force times length; N mm (SI: J) in axisymmetry and three dimensions.'
        ),
    ]
    pressure: Annotated[
        list[float],
        Field(
            description='Largest pressure of a cell of each row. Unit: MPa (SI: Pa).'
        ),
    ]
    tilt: Annotated[
        float,
        Field(
            description='Tilt of one body against the other, that is given or under a moment that is given found: positive where the surfaces are brought closer at positive y. Without force it is that of the last contact. Unit: mrad.'
        ),
    ]
    y: Annotated[
        list[float],
        Field(description='Middles of the rows along the roller. Unit: mm (SI: m).'),
    ]


class RoughContact(BaseModel):
    """
    The contact of surfaces with heights on top of their shapes. `area` is that of the cells in contact, a and b are half of what lies between the outermost of them.
    """

    contact_ratio: Annotated[
        float,
        Field(
            description='Area of the cells in contact over that of all heights. Without unit.',
            ge=0.0,
        ),
    ]
    nominal_pressure: Annotated[
        float,
        Field(
            description='Force over the area of all heights. Unit: MPa (SI: Pa).',
            ge=0.0,
        ),
    ]
    parts: Annotated[
        list[float], Field(description='Parts of the area in contact. Without unit.')
    ]
    plastic_part: Annotated[
        float | None,
        Field(
            description='Part of the area in contact below which a body has yielded at some depth; `null` where none has a hardening curve. Without unit.',
            ge=0.0,
        ),
    ] = None
    pressure_quantiles: Annotated[
        list[float],
        Field(
            description='Pressure below which these parts of the area in contact are; empty where nothing touches. Unit: MPa (SI: Pa).'
        ),
    ]


class ShakedownLimit(BaseModel):
    """
    Elastic peak pressure up to which a line contact shakes down under a friction.
    """

    depth: Annotated[
        float,
        Field(
            description='Depth that decides, 0 where the surface does. Unit: mm (SI: m).',
            ge=0.0,
        ),
    ]
    friction: Annotated[
        float,
        Field(
            description='Traction over pressure in the whole contact. Without unit.',
            ge=0.0,
        ),
    ]
    pressure: Annotated[
        float, Field(description="Hertz's peak pressure. Unit: MPa (SI: Pa).", ge=0.0)
    ]


class Sphere(BaseModel):
    """
    A ball on a half-space; only in three dimensions.
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
            description='Angle of the body about the normal, in degrees, from x towards y; 0 if it is left out. Without unit.',
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


class Subsurface(BaseModel):
    """
    Stresses along a normal of the surface.
    """

    depth: Annotated[
        list[float],
        Field(description='Depth below the surface, from 0. Unit: mm (SI: m).'),
    ]
    equivalent_plastic_strain: Annotated[
        list[float], Field(description='Equivalent plastic strain. Without unit.')
    ]
    initial_sigma_x: Annotated[
        list[float] | None,
        Field(
            description='Tangential stress before the load, what is left of an initial stress after the body has relaxed; a part of `sigma_x`. Unit: MPa (SI: Pa).'
        ),
    ] = None
    initial_sigma_y: Annotated[
        list[float] | None,
        Field(description='Normal stress before the load. Unit: MPa (SI: Pa).'),
    ] = None
    initial_sigma_z: Annotated[
        list[float] | None,
        Field(description='Out-of-plane stress before the load. Unit: MPa (SI: Pa).'),
    ] = None
    position: Annotated[
        float | None,
        Field(
            description='x of the normal, along the arc for a pin in a hole. Results of 0.2 do not have it: their normal is at `contact.peak_position`. Unit: mm (SI: m).'
        ),
    ] = None
    position_y: Annotated[
        float | None,
        Field(
            description='y of the normal; of this and the following only in three dimensions, where `sigma_x` is `sigma_xx`, the normal stress `sigma_y` is `sigma_zz`, and `sigma_z` is `sigma_yy`. Unit: mm (SI: m).'
        ),
    ] = None
    sigma_x: Annotated[
        list[float],
        Field(
            description='Tangential stress; radial in axisymmetry. Unit: MPa (SI: Pa).'
        ),
    ]
    sigma_xx: Annotated[
        list[float] | None,
        Field(
            description='Stress along x, the shorter semi-axis of the contact. Unit: MPa (SI: Pa).'
        ),
    ] = None
    sigma_xy: Annotated[
        list[float] | None,
        Field(description='Shear stress between x and y. Unit: MPa (SI: Pa).'),
    ] = None
    sigma_xz: Annotated[
        list[float] | None,
        Field(description='Shear stress between x and z. Unit: MPa (SI: Pa).'),
    ] = None
    sigma_y: Annotated[
        list[float],
        Field(description='Normal stress; axial in axisymmetry. Unit: MPa (SI: Pa).'),
    ]
    sigma_yy: Annotated[
        list[float] | None,
        Field(description='Stress along y, the longer semi-axis. Unit: MPa (SI: Pa).'),
    ] = None
    sigma_yz: Annotated[
        list[float] | None,
        Field(description='Shear stress between y and z. Unit: MPa (SI: Pa).'),
    ] = None
    sigma_z: Annotated[
        list[float],
        Field(
            description='Out-of-plane stress; hoop stress in axisymmetry. Unit: MPa (SI: Pa).'
        ),
    ]
    sigma_zz: Annotated[
        list[float] | None,
        Field(
            description='Stress along z, the normal into the body. Unit: MPa (SI: Pa).'
        ),
    ] = None
    tau_max: Annotated[
        list[float],
        Field(
            description='Largest shear stress, half the difference of the extreme principal stresses. Unit: MPa (SI: Pa).'
        ),
    ]
    utilization: Annotated[
        list[float] | None,
        Field(description='Von Mises stress over that yield stress. Without unit.'),
    ] = None
    von_mises: Annotated[
        list[float], Field(description='Von Mises stress. Unit: MPa (SI: Pa).')
    ]
    yield_stress: Annotated[
        list[float] | None,
        Field(
            description='Yield stress; only where it varies with the depth. Unit: MPa (SI: Pa).'
        ),
    ] = None


class SubsurfaceOfBodies(BaseModel):
    """
    One value for each body.
    """

    lower: Annotated[
        Subsurface | None,
        Field(
            description='Of the lower body; null if it is rigid or the step was stopped.'
        ),
    ]
    upper: Annotated[
        Subsurface | None,
        Field(
            description='Of the upper body; null if it is rigid or the step was stopped.'
        ),
    ]


class Surface(BaseModel):
    """
    The surface of one body near the contact.
    """

    depth: Annotated[
        float,
        Field(
            description='Depth of the deepest point below the undeformed surface. Unit: mm (SI: m).',
            ge=0.0,
        ),
    ]
    height: Annotated[
        list[float],
        Field(
            description='How far each has moved outward from the undeformed surface; a dent is negative. Unit: mm (SI: m).'
        ),
    ]
    max_reverse_strain: Annotated[
        float,
        Field(
            description='Largest equivalent plastic strain gained since then. Without unit.',
            ge=0.0,
        ),
    ]
    pile_up: Annotated[
        float,
        Field(
            description='Height of the highest point above the undeformed surface. Unit: mm (SI: m).',
            ge=0.0,
        ),
    ]
    pile_up_position: Annotated[
        float, Field(description='|x| of that point. Unit: mm (SI: m).', ge=0.0)
    ]
    reverse_area: Annotated[
        float,
        Field(
            description='Area of these points in the section x–y, both sides of the axis. Unit: mm² (SI: m²).',
            ge=0.0,
        ),
    ]
    x: Annotated[
        list[float],
        Field(
            description='x of the nodes, both sides of the axis; arc lengths for a pin in a hole. Unit: mm (SI: m).'
        ),
    ]
    yielded_in_reverse: Annotated[
        bool,
        Field(
            description='Whether any point yielded since the load last began to fall.'
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


class SurfaceOfBodies(BaseModel):
    """
    One value for each body.
    """

    lower: Annotated[
        Surface | None,
        Field(
            description='Of the lower body; null if it is rigid or the step was stopped.'
        ),
    ]
    upper: Annotated[
        Surface | None,
        Field(
            description='Of the upper body; null if it is rigid or the step was stopped.'
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


class TargetResult(BaseModel):
    """
    The force under which a figure of the contact has the value that a job asked for.
    """

    figure: Annotated[
        str,
        Field(
            description='Which figure: `permanent_approach`, `dent_depth`, `peak_pressure`, `mean_pressure`, `half_width` or `max_plastic_strain`.'
        ),
    ]
    force: Annotated[
        float,
        Field(
            description='The force. Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions.',
            ge=0.0,
        ),
    ]
    reached: Annotated[
        float,
        Field(
            description='The value that it has under the force. Unit: that of the figure, mm or MPa (SI: m or Pa); plastic strain without one.'
        ),
    ]
    relative_error: Annotated[
        float | None,
        Field(
            description='Estimated bound of the relative error of the force: what the figure is off by, and what the mesh may have done to it. `null` where there is no estimate for the figure. Without unit.',
            ge=0.0,
        ),
    ]
    sensitivity: Annotated[
        float,
        Field(
            description='Relative change of the figure over the relative change of the force. Without unit.'
        ),
    ]
    wanted: Annotated[
        float,
        Field(
            description='The value that it was to have. Unit: that of the figure, mm or MPa (SI: m or Pa); plastic strain without one.'
        ),
    ]


class Point3Item(RootModel[float]):
    root: Annotated[
        float,
        Field(
            description='Strain, elastic part included. Without unit.',
            ge=-10000000.0,
            le=10000000.0,
        ),
    ]


class Point3Item1(RootModel[float]):
    root: Annotated[
        float,
        Field(
            description='Stress. Range: -1e7 to 1e7 MPa or -1e13 to 1e13 Pa.',
            ge=-10000000000000.0,
            le=10000000000000.0,
        ),
    ]


class Point3(RootModel[tuple[Point3Item, Point3Item1]]):
    root: Annotated[
        tuple[Point3Item, Point3Item1],
        Field(description='One point.', max_length=2, min_length=2),
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


class ThreeDimensional(BaseModel):
    """
    What only a contact in three dimensions has. x lies along the shorter semi-axis of the contact, y along the longer one, z into the body; every place, map and stress of this step is in these axes.
    """

    a: Annotated[
        float,
        Field(
            description='Shorter semi-axis; 0 where nothing touches. Unit: mm (SI: m).',
            ge=0.0,
        ),
    ]
    area: Annotated[
        float,
        Field(
            description='Area of the ellipse of these semi-axes. Unit: mm² (SI: m²).',
            ge=0.0,
        ),
    ]
    b: Annotated[
        float, Field(description='Longer semi-axis. Unit: mm (SI: m).', ge=0.0)
    ]
    estimated_error: Annotated[
        EllipseErrors | None,
        Field(
            description='Estimated relative errors of further figures; absent where `estimated_error` is `null`.'
        ),
    ] = None
    hertz: Annotated[
        EllipticHertz | None,
        Field(
            description='The elastic contact of the same bodies under the same force; absent where nothing touches.'
        ),
    ] = None
    largest_cell_pressure: Annotated[
        float,
        Field(
            description='Largest pressure of one cell. `contact.peak_pressure` is a mean over neighbours, weights 1-2-1 each way, where bodies yield, because the pressure of single cells is jagged near the edge. Unit: MPa (SI: Pa).',
            ge=0.0,
        ),
    ]
    maps: Annotated[
        ContactMaps | None,
        Field(
            description='Pressure, gap and dent of all cells; absent unless `output.fields` asks for them.'
        ),
    ] = None
    orientation: Annotated[
        float,
        Field(
            description='Angle from the x of the job to this x, towards the y of the job; 0 of a circle. Unit: degree.'
        ),
    ]
    peak_position_y: Annotated[
        float,
        Field(
            description='y of the largest pressure; its x is `contact.peak_position`. Unit: mm (SI: m).'
        ),
    ]
    roller: Annotated[
        RollerContact | None,
        Field(description='What is said along a roller; absent without one.'),
    ] = None
    section: Annotated[
        ContactSection,
        Field(
            description='The cells of the section x = 0; those of the section y = 0 are `contact.nodes`.'
        ),
    ]
    surface: Annotated[
        RoughContact | None,
        Field(description='What is said of a contact of heights; absent without them.'),
    ] = None


class Timings(BaseModel):
    """
    Wall time by phase, all passes and steps together. Unit: ms.
    """

    assembly: Annotated[
        float, Field(description='Stiffness assembly. Unit: ms.', ge=0.0)
    ]
    contact: Annotated[float, Field(description='Contact solves. Unit: ms.', ge=0.0)]
    flexibility: Annotated[
        float, Field(description='Contact flexibility matrix. Unit: ms.', ge=0.0)
    ]
    mesh: Annotated[float, Field(description='Mesh generation. Unit: ms.', ge=0.0)]
    numeric: Annotated[
        float, Field(description='Numeric factorization. Unit: ms.', ge=0.0)
    ]
    ordering: Annotated[
        float, Field(description='Fill-reducing ordering. Unit: ms.', ge=0.0)
    ]
    output: Annotated[
        float, Field(description='Final fields and this report. Unit: ms.', ge=0.0)
    ]
    plasticity: Annotated[
        float,
        Field(description='Plastic law and initial-stress loads. Unit: ms.', ge=0.0),
    ]
    solves: Annotated[
        float, Field(description='Forward and back substitutions. Unit: ms.', ge=0.0)
    ]
    symbolic: Annotated[
        float, Field(description='Symbolic factorization. Unit: ms.', ge=0.0)
    ]
    total: Annotated[float, Field(description='Everything. Unit: ms.', ge=0.0)]


class TrackLimit(BaseModel):
    """
    A limit of shakedown.
    """

    body: Annotated[
        Literal['upper', 'lower'], Field(description='The body that decides.')
    ]
    depth: Annotated[
        float,
        Field(
            description='Depth that decides, 0 where the surface does. Unit: mm (SI: m).',
            ge=0.0,
        ),
    ]
    peak_pressure: Annotated[
        float, Field(description="Hertz's peak pressure. Unit: MPa (SI: Pa).", ge=0.0)
    ]


class TrackLimits(BaseModel):
    """
    Elastic peak pressures up to which a track shakes down.
    """

    kinematic: TrackLimit | None
    over_friction: Annotated[
        list[FrictionLimits] | None,
        Field(
            description='Limits over friction, for strength and initial stress at the depths of this contact; empty where no body has a yield point.'
        ),
    ] = None
    perfect: TrackLimit | None
    shear_yield_stress: Annotated[
        float | None,
        Field(
            description='Yield stress in shear, of both bodies the lower, where strength does not vary; `null` where none yields. Unit: MPa (SI: Pa).',
            ge=0.0,
        ),
    ]


class Validation(BaseModel):
    """
    Answer to a job that could be solved.
    """

    estimate: Annotated[Estimate, Field(description='What it would cost.')]
    valid: Annotated[
        bool,
        Field(
            description='Always true; a job at fault is answered by a problem.',
            examples=[True],
        ),
    ]


class ValidityNote(BaseModel):
    """
    One remark on the validity of the answer.
    """

    code: Annotated[
        str,
        Field(
            description='Stable identifier. There may be more in the future.',
            examples=['not_converged', 'cancelled', 'timed_out', 'slow_coupling', 'wide_contact', 'large_strain', 'collapse', 'deformation_theory', 'falling_loads', 'no_contact', 'contact_at_edge', 'coarse_mesh', 'coarse_case', 'onset_unknown', 'unbounded_strain', 'bilinear_curve', 'initial_yield', 'yield_by_hardness', 'near_support', 'sharp_corner', 'suspicious_units', 'suspicious_curve', 'suspicious_profile', 'suspicious_heights', 'half_spaces', 'roller_end', 'surface_end', 'near_limit', 'full_sliding', 'bias_unknown', 'blunt_tip', 'equal_cone', 'narrow_specimen', 'no_dent', 'outside_scale', 'thin_specimen'],
        ),
    ]
    message: Annotated[str, Field(description='For a person.')]


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


class YieldOnset(BaseModel):
    """
    The onset of yield, found numerically for the job's own shapes.
    """

    approach: Annotated[
        float, Field(description='Approach under it. Unit: mm (SI: m).')
    ]
    body: Annotated[
        Literal['upper', 'lower'],
        Field(description='Which body yields first; of two alike, the lower one.'),
    ]
    depth: Annotated[
        float, Field(description='Depth of that middle. Unit: mm (SI: m).')
    ]
    force: Annotated[
        float,
        Field(
            description='Force P_Y. Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions.',
            ge=0.0,
        ),
    ]
    peak_pressure: Annotated[
        float, Field(description='Peak pressure under it. Unit: MPa (SI: Pa).', ge=0.0)
    ]
    position: Annotated[
        float,
        Field(
            description='x of the middle of the first element to yield; a symmetric contact has its mirror image as well. Unit: mm (SI: m).'
        ),
    ]


class Answer(BaseModel):
    """
    One figure of a load step, made to be shown.
    """

    bias: Annotated[
        float | None,
        Field(
            description="The figure of deformation theory less that of flow theory, over the figure's size; `null` where the theories do not differ or it is not known. Without unit."
        ),
    ]
    bias_error: Annotated[
        float | None,
        Field(
            description='Estimated bound of the error of the bias; `null` without one. Without unit.',
            ge=0.0,
        ),
    ]
    body: Literal['upper', 'lower', 'both'] | None
    elastic: Annotated[
        float | None,
        Field(description="The figure by Hertz's elastic theory, where that has one."),
    ]
    error: Annotated[
        float | None,
        Field(
            description='Estimated bound of its relative error by the mesh, as in `estimated_error`; 0 where it is prescribed, `null` where it is not known or as large as the figure, whose bound `text` then says. Without unit.',
            ge=0.0,
        ),
    ]
    label: Annotated[str, Field(description='Name for a person.')]
    name: Annotated[
        str,
        Field(
            description='Stable identifier, such as `peak_pressure`. An identifier may occur once for each body.'
        ),
    ]
    place: AnswerPlace | None
    quantity: Annotated[
        str,
        Field(
            description='Its physical quantity. A `strain` and a `ratio` are shown in per cent.',
            examples=['length', 'area', 'stress', 'force', 'line_force', 'stiffness', 'line_stiffness', 'energy', 'line_energy', 'strain', 'ratio', 'number', 'angle'],
        ),
    ]
    text: Annotated[
        str,
        Field(
            description='A note for a person: over which points a maximum was taken, or against what the figure counts.'
        ),
    ]
    unit: Annotated[
        str,
        Field(
            description='Symbol of its unit in the units of the job; empty of a strain, a ratio and a number.'
        ),
    ]
    value: Annotated[
        float | None,
        Field(
            description='The figure in `unit`; `null` where it is not known, and `text` says why.'
        ),
    ]


class BatchOfIds(BaseModel):
    """
    Jobs that exist.
    """

    ids: Annotated[
        list[UUID], Field(description='Their ids.', max_length=100, min_length=1)
    ]


class Callback(BaseModel):
    """
    The announcement of a job's end.
    """

    attempts: Annotated[int, Field(description='Attempts so far.', ge=0)]
    delivered_at: Annotated[
        AwareDatetime | None, Field(description='When the receiver took it.')
    ] = None
    id: Annotated[
        UUID,
        Field(
            description='What the receiver finds in `webhook-id`, the same in every attempt.'
        ),
    ]
    last_error: Annotated[
        str | None, Field(description='Why the last attempt failed.')
    ] = None
    last_status: Annotated[
        int | None,
        Field(
            description='HTTP status of the last attempt, if there was one.',
            ge=100,
            le=999,
        ),
    ] = None
    next_attempt_at: Annotated[
        AwareDatetime | None, Field(description='When the next attempt is made.')
    ] = None
    state: Annotated[
        Literal['waiting', 'pending', 'delivered', 'failed'],
        Field(description='How far it has come.'),
    ]


class Capacity(BaseModel):
    """
    What a node can do and how busy the queue is.
    """

    limits: Annotated[Limits, Field(description='What a single request may ask for.')]
    memory_bytes: Annotated[
        int, Field(description='Memory that they may need together. Unit: byte.', ge=0)
    ]
    queue: Annotated[Queue, Field(description='The queue, of all nodes that share it.')]
    solvers: Annotated[
        int,
        Field(
            description='Jobs solved here at the same time; 0 on a node without solvers.',
            examples=[8],
            ge=0,
        ),
    ]


class ClosedForm(BaseModel):
    """
    Hertz's contact of the bodies of a job, in the units of the job.
    """

    effective_radius: Annotated[
        float,
        Field(
            description='Effective radius of the two surfaces, along the shorter side of their contact. Unit: mm (SI: m).',
            examples=[10.0],
            gt=0.0,
        ),
    ]
    steps: Annotated[
        list[ClosedFormStep], Field(description='One for each force of the load.')
    ]
    units: Annotated[
        str,
        Field(
            description='Units of all figures: `mm_N_MPa` or `SI`.',
            examples=['mm_N_MPa'],
        ),
    ]
    yield_onset_force: Annotated[
        float | None,
        Field(
            description='Force at which the first body begins to yield; `null` if none can. Unit: N/mm (SI: N/m); N in axisymmetry and three dimensions.',
            examples=[218.99],
            ge=0.0,
        ),
    ]


class Contact(BaseModel):
    """
    Contact pressure and its resultants, both sides of the axis.
    """

    force: Annotated[
        float,
        Field(
            description='Sum of the nodal forces along the approach. Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions.',
            ge=0.0,
        ),
    ]
    half_angle: Annotated[
        float | None,
        Field(
            description='Angle over which a pin touches its hole to each side of the middle; only of these. Unit: degree.',
            ge=0.0,
        ),
    ] = None
    half_width: Annotated[
        float,
        Field(
            description='Half of the distance between the ends of the pressure, along the arc for a pin in a hole. Unit: mm (SI: m).',
            ge=0.0,
        ),
    ]
    mean_pressure: Annotated[
        float,
        Field(
            description='Force over width, or over the area of the contact circle; of a pin in a hole over those across the approach. Unit: MPa (SI: Pa).',
            ge=0.0,
        ),
    ]
    middle_pressure: Annotated[
        float,
        Field(
            description='Pressure in the middle of the contact; of a roller the largest across its middle, 0 of heights. Unit: MPa (SI: Pa).',
            ge=0.0,
        ),
    ]
    nodes: Annotated[
        ContactNodes, Field(description='The candidate pairs in order of x.')
    ]
    patches: Annotated[
        list[Patch],
        Field(description='The connected parts of the contact, from left to right.'),
    ]
    peak_position: Annotated[
        float,
        Field(
            description='x of the largest pressure; where nothing touches, of the largest that the history had. Unit: mm (SI: m).'
        ),
    ]
    peak_pressure: Annotated[
        float, Field(description='Largest pressure. Unit: MPa (SI: Pa).', ge=0.0)
    ]


class Flow(BaseModel):
    """
    What only flow theory knows of a step.
    """

    energy: Annotated[
        Energy,
        Field(
            description='Where the work of the force has gone since the bodies were at rest.'
        ),
    ]
    increments: Annotated[Increments, Field(description='The increments of this load.')]
    surfaces: Annotated[
        SurfaceOfBodies,
        Field(
            description='The surface of each body: the dent where the force is zero.'
        ),
    ]
    unloading_stiffness: Annotated[
        float,
        Field(
            description='dP/dα where the load begins to fall: that of the elastic bodies with the pairs in contact. 0 where nothing touches. Unit: N/mm² (SI: N/m²); in axisymmetry and three dimensions N/mm (SI: N/m).',
            ge=0.0,
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


class HardnessResult(BaseModel):
    """
    The hardness that a test finds.
    """

    bias: Annotated[
        float | None,
        Field(
            description='Mean pressure over that of a published result with large strains, less 1; `null` where none is known, as a remark says. Without unit.'
        ),
    ]
    bias_source: Annotated[str | None, Field(description='The published result.')]
    constraint: Annotated[
        float | None,
        Field(
            description="Mean pressure over this stress; Tabor's is 2.8. Without unit."
        ),
    ]
    curvature_bias: Annotated[
        float | None,
        Field(
            description='Loading curvature F/h² of a pyramid over that of Dao et al., less 1. Without unit.'
        ),
    ]
    depth: Annotated[
        float, Field(description='Depth of the indentation under it. Unit: mm (SI: m).')
    ]
    depth_error: Annotated[
        float | None,
        Field(
            description='Estimated bound of the relative error of the depth by the mesh. Without unit.',
            ge=0.0,
        ),
    ]
    diameter: Annotated[
        float,
        Field(
            description='Diameter of the contact under it; of pyramids the diagonal of a square of equal area. Unit: mm (SI: m).'
        ),
    ]
    flow_stress: Annotated[
        float | None,
        Field(description='Stress of the curve at this strain. Unit: MPa (SI: Pa).'),
    ]
    force: Annotated[
        float,
        Field(
            description='Largest force. Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions.'
        ),
    ]
    least_thickness: Annotated[
        float | None,
        Field(
            description='Least thickness of the specimen by the standard. Unit: mm (SI: m).'
        ),
    ]
    mean_pressure: Annotated[
        float,
        Field(
            description="Force over the area of the contact, Meyer's hardness. Unit: MPa (SI: Pa)."
        ),
    ]
    meyer_exponent: Annotated[
        float | None,
        Field(
            description="Exponent of Meyer's law, force over diameter. Without unit."
        ),
    ]
    number: Annotated[
        float | None,
        Field(
            description='Hardness number; `null` of `berkovich` and `sphere`, whose hardness is `mean_pressure`, and where a load did not converge. Without unit.',
            ge=0.0,
        ),
    ]
    number_error: Annotated[
        float | None,
        Field(description='The same in points of the scale. Without unit.', ge=0.0),
    ]
    oliver_pharr: OliverPharr | None
    permanent_depth: Annotated[
        float | None, Field(description='Depth that is left. Unit: mm (SI: m).')
    ]
    pile_up: Annotated[
        float,
        Field(
            description='Height of the edge of the contact under load over the plane surface: above 0 piled up, below 0 sunk in. Unit: mm (SI: m).'
        ),
    ]
    relative_error: Annotated[
        float | None,
        Field(
            description='Estimated bound of the relative error of the number, or of the mean pressure, by the mesh; `null` of Rockwell numbers, whose zero is a convention. Without unit.',
            ge=0.0,
        ),
    ]
    remarks: Annotated[list[ValidityNote], Field(description='What to keep in mind.')]
    representative_strain: Annotated[
        float | None,
        Field(
            description="Tabor's representative plastic strain: 0.2 a/R of a ball, 0.08 of a pyramid. Without unit."
        ),
    ]
    rim_diameter: Annotated[
        float | None,
        Field(
            description='Diameter of the highest points around the indentation that is left; `null` where nothing is piled up. Unit: mm (SI: m).'
        ),
    ]
    test: Annotated[str, Field(description='Name of the test, e.g. `HBW 10/3000`.')]


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


class Hertz(BaseModel):
    """
    Hertz's elastic contact under the same force.
    """

    half_width: Annotated[
        float, Field(description='Half-width a. Unit: mm (SI: m).', ge=0.0)
    ]
    peak_pressure: Annotated[
        float, Field(description='Peak pressure. Unit: MPa (SI: Pa).', ge=0.0)
    ]
    shakedown_depth: Annotated[
        float | None,
        Field(description='Depth that decides on it. Unit: mm (SI: m).', ge=0.0),
    ]
    shakedown_over_friction: Annotated[
        list[ShakedownLimit] | None,
        Field(
            description='The same limit of a line contact in plane strain with friction, which slides over the whole contact: of both bodies the lower, for either sense of the friction. Empty of all other contacts, and where `shakedown_pressure` is `null`.'
        ),
    ] = None
    shakedown_pressure: Annotated[
        float | None,
        Field(
            description='Elastic peak pressure up to which the contact shakes down when it rolls freely, by the orthogonal shear stress over depth: where strength is the same everywhere, 4 k of a line in plane strain. In three dimensions it rolls along its shorter semi-axis, and this is an upper bound: 4.68 k of a circle. `null` without yield, in plane stress and in axisymmetry. Unit: MPa (SI: Pa).',
            ge=0.0,
        ),
    ]
    yield_onset_depth: Annotated[
        float | None,
        Field(description='Depth at which it does. Unit: mm (SI: m).', ge=0.0),
    ]
    yield_onset_force: Annotated[
        float | None,
        Field(
            description='Force at which the first body begins to yield; `null` if none can. Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions.',
            ge=0.0,
        ),
    ]


class Pass(BaseModel):
    """
    One pass of the load.
    """

    approach: Annotated[
        float | None,
        Field(
            description='Approach of the bodies; `null` of a line, which has none. Unit: mm (SI: m).'
        ),
    ]
    bodies: Annotated[
        BodyPassOfBodies,
        Field(
            description='What the pass leaves in each body; `null` of one that cannot yield.'
        ),
    ]
    energy_gap: Annotated[
        float,
        Field(
            description='What is missing in the balance of these works over the plastic work; 0 without one. Without unit.',
            ge=0.0,
        ),
    ]
    estimated_error: PassErrors | None
    half_width: Annotated[
        float,
        Field(
            description='Half-width of the contact along the travel. Unit: mm (SI: m).',
            ge=0.0,
        ),
    ]
    half_width_across: Annotated[
        float | None,
        Field(
            description='Half-width of the contact across the travel; `null` of a line. Unit: mm (SI: m).',
            ge=0.0,
        ),
    ]
    iterations: Annotated[int, Field(description='Iterations made.', ge=0)]
    loss: Annotated[
        float,
        Field(
            description='The same over the load: the coefficient of rolling resistance. Without unit.'
        ),
    ]
    number: Annotated[int, Field(description='Number of the pass, from 1.', ge=0)]
    peak_pressure: Annotated[
        float, Field(description='Peak pressure. Unit: MPa (SI: Pa).', ge=0.0)
    ]
    plastic_work: Annotated[
        float,
        Field(
            description='Work of plastic flow in both bodies. Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions.',
            ge=0.0,
        ),
    ]
    rolling_force: Annotated[
        float,
        Field(
            description='Force against which the load is pushed, without friction. Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions.'
        ),
    ]
    stored_energy: Annotated[
        float,
        Field(
            description='Change of the elastic energy of the residual stress. Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions.'
        ),
    ]
    traction_work: Annotated[
        float,
        Field(
            description='Work of the friction on the plastic displacement of the surfaces. Unit: N/mm (SI: N/m) of thickness; N in axisymmetry and three dimensions.'
        ),
    ]


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
    passes: Annotated[
        int | None, Field(description='Passes at most. Default: `30`.', ge=1, le=100)
    ] = None
    track: Annotated[
        float | None,
        Field(
            description='Length of the track over the elastic half-width or the semi-axis along the travel, after which the material comes back; 32 of a line and 12 in three dimensions, where it is missing. It acts on the first pass alone. Without unit.',
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


class RollingResult(BaseModel):
    """
    The passes of a load that rolls and what becomes of the track. x points along the travel, and z across it. Works are those per length of travel, of a line on unit thickness too: forces.
    """

    body: Literal['upper', 'lower'] | None
    columns: Annotated[int, Field(description='Columns of the track.', ge=0)]
    friction: Annotated[
        float | None,
        Field(
            description='Traction over pressure in the whole contact, positive along the travel on the lower body. Without unit.'
        ),
    ] = None
    layers: Annotated[int, Field(description='Layers of each body.', ge=0)]
    limits: Annotated[
        TrackLimits,
        Field(
            description='Elastic peak pressures up to which the track shakes down under this friction.'
        ),
    ]
    passes: Annotated[list[Pass], Field(description='The passes that have converged.')]
    rate: Annotated[
        float | None,
        Field(
            description='Plastic strain of a steady pass, or of a pair of passes there and back: net strain of a track that ratchets, accumulated strain of one that closes a cycle, 0 of one that shakes down; `null` where it is undecided. Without unit.',
            ge=0.0,
        ),
    ]
    rate_error: Annotated[
        float | None,
        Field(
            description='Estimated error of the rate by columns, and its change over three passes. Without unit.',
            ge=0.0,
        ),
    ]
    reason: Annotated[
        str | None,
        Field(
            description='Why the verdict is open or the passes end; `null` otherwise.'
        ),
    ]
    rows: Annotated[
        int,
        Field(
            description='Rows of cells in a layer on one side of the axis of the track, over which all fields are symmetric; 1 of a line.',
            ge=0,
        ),
    ]
    verdict: Annotated[
        Literal['elastic', 'shakes_down', 'closed_cycle', 'undecided', 'ratchets'],
        Field(description='What becomes of the track, of both bodies the worse.'),
    ]


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
    theory: Annotated[
        Literal['deformation', 'flow'] | None,
        Field(
            description='Theory of plasticity: `deformation` knows no unloading, `flow` follows the loads as a history. Default: `deformation`.'
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


class TensileTest(BaseModel):
    """
    Strain and stress of a tensile or compression test, elastic part included.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
    measure: Annotated[
        Literal['engineering', 'true'] | None,
        Field(
            description='`engineering` (over first length and section), unless given, or `true`.'
        ),
    ] = None
    offset: Annotated[
        float | None,
        Field(
            description='Plastic strain at yield: 0.0001, R_p0.01, unless given; 0.002 is R_p0.2. Without unit.',
            ge=1e-07,
            le=0.05,
        ),
    ] = None
    points: Annotated[
        list[Point3],
        Field(
            description='Points `[strain, stress]` in the order of their recording. Negative strain and stress are compression.',
            examples=[[[0.0, 0.0], [0.001, 210.0], [0.0024, 500.0], [0.02, 540.0], [0.05, 580.0]]],
            max_length=100000,
            min_length=3,
        ),
    ]
    strain_unit: Annotated[
        Literal['1', 'percent', 'microstrain'] | None,
        Field(description='Unit of the strain: `1` unless given.'),
    ] = None
    units: Annotated[
        Literal['mm_N_MPa', 'SI'] | None,
        Field(description='Units of the stresses. Default: `mm_N_MPa`.'),
    ] = None
    yield_at: Annotated[
        Literal['offset', 'departure'] | None,
        Field(
            description='What counts as yield: `offset`, unless given, or `departure`, where the record leaves its first line for good.'
        ),
    ] = None
    young_modulus: Annotated[
        float | None,
        Field(
            description="Young's modulus of the job, which the first slope is compared with, and which takes its place where no part of the record is straight. Range: 1e-3 to 1e8 MPa or 1e3 to 1e14 Pa.",
            ge=0.001,
            le=100000000000000.0,
        ),
    ] = None


class Verdict(BaseModel):
    """
    The verdict on a load step.
    """

    level: Annotated[
        str,
        Field(
            description='The state of the bodies.',
            examples=['not_converged', 'collapse', 'above_shakedown_limit', 'ratchets', 'closed_cycle', 'shakes_down', 'yields', 'dented', 'elastic', 'not_known', 'no_contact'],
        ),
    ]
    text: Annotated[str, Field(description='One sentence for a person.')]


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


class Step(BaseModel):
    """
    One load step.
    """

    answers: Annotated[
        list[Answer],
        Field(
            description='The figures that answer the job, in the order in which it asks for them; empty of results of 0.2 and of a step that was stopped.'
        ),
    ]
    approach: Annotated[
        float | None,
        Field(
            description='Approach α of the supports; `null` of a line contact that rolls, which has none. Unit: mm (SI: m).'
        ),
    ]
    approach_datum: Annotated[
        str, Field(description='Between which two boundaries α is counted.')
    ]
    contact: Annotated[
        Contact, Field(description='Contact pressure and its resultants.')
    ]
    contact_stiffness: Annotated[
        float | None,
        Field(
            description='Contact stiffness dP/dα: the slope of the load-approach curve at this load, with the plastic flow that it brings; 0 where nothing touches. `null` where bodies yield as the load rises and `output.contact_stiffness` does not ask for it, where the answer did not converge, and where bodies flow at a constant stress in plane stress. Unit: N/mm² (SI: N/m²); in axisymmetry and three dimensions N/mm (SI: N/m).'
        ),
    ]
    estimated_error: ErrorEstimate | None
    fields: Annotated[
        FieldsOfBodies | None,
        Field(description='Mesh and nodal fields; absent unless asked for.'),
    ] = None
    flow: Annotated[
        Flow | None,
        Field(
            description='What only flow theory knows: increments, dents, energies; absent under deformation theory.'
        ),
    ] = None
    hertz: Hertz | None
    history: Annotated[list[Iteration1], Field(description='Every outer iteration.')]
    layers: Annotated[
        LayersOfBodies | None,
        Field(
            description='Stresses and plastic strain in the layers of half-spaces in three dimensions, which have no mesh; absent unless `output.fields` asks for them.'
        ),
    ] = None
    load: Annotated[
        PrescribedForce | PrescribedApproach, Field(description='What was prescribed.')
    ]
    plasticity: Annotated[
        PlasticZoneOfBodies,
        Field(description='Plastic zone of each body; `null` for a rigid one.'),
    ]
    rolling: Annotated[
        RollingResult | None,
        Field(
            description='Passes of a load that rolls, and what becomes of the track; absent of all other loads.'
        ),
    ] = None
    status: Annotated[
        str,
        Field(
            description='How this step ended.',
            examples=['converged', 'not_converged', 'cancelled', 'timed_out'],
        ),
    ]
    subsurface: Annotated[
        SubsurfaceOfBodies | None,
        Field(
            description='Stresses over depth on the axis, or below the middle of the contact where there is none; of a load that rolls what its last pass has left, the same all along the track. Absent when not asked for, and where the step was stopped.'
        ),
    ] = None
    subsurface_below_peak: Annotated[
        SubsurfaceOfBodies | None,
        Field(
            description='The same below the largest pressure; absent where that is in the middle.'
        ),
    ] = None
    three_dimensional: Annotated[
        ThreeDimensional | None,
        Field(
            description='What only a contact in three dimensions has; absent in other analyses.'
        ),
    ] = None
    validity: Annotated[
        list[ValidityNote], Field(description='What to keep in mind about this answer.')
    ]
    verdict: Annotated[
        Verdict | None,
        Field(
            description='The state of the bodies in one sentence; absent of results of 0.2.'
        ),
    ] = None
    yield_onset: YieldOnset | None


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


class Report(BaseModel):
    """
    The answer to a job.
    """

    analysis: Annotated[
        Literal['plane_strain', 'plane_stress', 'axisymmetric', 'three_dimensional'],
        Field(
            description='Plane strain (long bodies), plane stress (thin discs), bodies of revolution about the line of approach, or half-spaces in three dimensions.'
        ),
    ]
    hardness: Annotated[
        HardnessResult | None,
        Field(
            description='The hardness that a test finds; only of a job with `load.hardness`.'
        ),
    ] = None
    load_approach: Annotated[
        LoadApproach | None, Field(description='The load–approach curve of a sweep.')
    ] = None
    mesh: Annotated[Mesh, Field(description='The mesh of the last step.')]
    status: Annotated[
        str,
        Field(
            description='The least good status of all steps.',
            examples=['converged', 'not_converged', 'cancelled', 'timed_out'],
        ),
    ]
    steps: Annotated[list[Step], Field(description='One entry for each load.')]
    tags: Tags | None = None
    target: Annotated[
        TargetResult | None,
        Field(
            description='The force that was asked for by what it does; only of a job with `load.target`.'
        ),
    ] = None
    timings_ms: Annotated[Timings, Field(description='Where the time went.')]
    units: Annotated[
        Literal['mm_N_MPa', 'SI'],
        Field(
            description='Units of every figure of the job and of its result: mm, N, MPa or m, N, Pa.'
        ),
    ]
    version: Annotated[str, Field(description='Version of the program.')]


class Job(BaseModel):
    """
    A job: where it stands, where to go from here and, when it finishes within the time its client waits, its result.
    """

    attempts: Annotated[int, Field(description='How often it was taken up.', ge=0)]
    callback: Annotated[
        Callback | None,
        Field(
            description='The announcement of its end, where it was handed in with a `callback_url`; not in lists of jobs.'
        ),
    ] = None
    cancel_requested: Annotated[
        bool, Field(description='Whether somebody asked it to stop.')
    ]
    created_at: Annotated[AwareDatetime, Field(description='When it was accepted.')]
    done: Annotated[
        bool, Field(description='Whether nothing can happen to it any more.')
    ]
    error: Annotated[Problem | None, Field(description='Why it failed.')] = None
    expires_at: Annotated[
        AwareDatetime | None,
        Field(
            description='When it is removed with its result; `null` until it is done.'
        ),
    ]
    finished_at: Annotated[
        AwareDatetime | None, Field(description='When it reached its final state.')
    ]
    has_result: Annotated[
        bool,
        Field(
            description='Whether there is a result to fetch, of a stopped job as far as it came.'
        ),
    ]
    id: Annotated[UUID, Field(description='Its name.')]
    links: Annotated[Links, Field(description='Where to go from here.')]
    priority: Annotated[int, Field(description='Larger goes first.', ge=-100, le=100)]
    progress: Annotated[Progress, Field(description='How far it has come.')]
    queue_position: Annotated[
        int | None,
        Field(description='Jobs before it in the queue, while it is queued.', ge=0),
    ] = None
    result: Annotated[
        Report | None,
        Field(
            description='The result; only in the answer to a client that waits, and only if the job is done by then.'
        ),
    ] = None
    started_at: Annotated[
        AwareDatetime | None, Field(description='When its latest attempt began.')
    ]
    status: Annotated[
        str,
        Field(
            description='Where it stands.',
            examples=['queued', 'running', 'succeeded', 'not_converged', 'failed', 'cancelled', 'timed_out'],
        ),
    ]
    tags: Tags | None = None


class JobList(BaseModel):
    """
    A page of jobs.
    """

    jobs: Annotated[
        list[Job],
        Field(
            description='Newest first. Places in the queue are told job by job only.'
        ),
    ]
    next_cursor: UUID | None


class BatchItem(BaseModel):
    """
    What became of one job: `job` or `problem`.
    """

    id: Annotated[
        UUID | None,
        Field(
            description='The job that was asked for; of jobs that are handed in, its new id is in `job`.'
        ),
    ] = None
    job: Annotated[Job | None, Field(description='The job as it is now.')] = None
    problem: Annotated[
        Problem | None,
        Field(description='Why not; pointers are those of the job by itself.'),
    ] = None
    replayed: Annotated[
        bool | None,
        Field(description='The same submission came before under its idempotency key.'),
    ] = None
    status: Annotated[
        int,
        Field(
            description='The HTTP status that a request for this job alone would have been answered with.',
            examples=[202],
            ge=200,
            le=599,
        ),
    ]


class Deformable(BaseModel):
    """
    An isotropic body, elastic unless it has a hardening curve.
    """

    model_config = ConfigDict(
        extra='forbid',
    )
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


class BatchAnswer(BaseModel):
    """
    What became of the jobs of a request, in their order.
    """

    accepted: Annotated[
        int, Field(description='How many there were of which nothing is wrong.', ge=0)
    ]
    jobs: Annotated[
        list[BatchItem],
        Field(description='One for each job of the request, in the same order.'),
    ]
    refused: Annotated[int, Field(description='How many were refused.', ge=0)]


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


class Example(BaseModel):
    """
    A job with its name.
    """

    job: ContactJob
    name: Annotated[
        str,
        Field(
            description='Its name, as that of its file in `api/examples`.',
            examples=['two_cylinders'],
        ),
    ]


class ExampleList(BaseModel):
    """
    Jobs to begin with, each with its keys in the order of its file.
    """

    examples: Annotated[list[Example], Field(description='Each under its name.')]


class BatchedJob(BaseModel):
    """
    One of the jobs to hand in.
    """

    callback_url: Annotated[
        str | None,
        Field(
            description='As `?callback_url=`: where to announce the end of the job.',
            examples=['https://hooks.example/brinell'],
            max_length=2000,
        ),
    ] = None
    idempotency_key: Annotated[
        str | None,
        Field(
            description='As the header `Idempotency-Key`, for this job alone; goes before the header.',
            examples=['press-7'],
            pattern='^[!-~]{1,255}$',
        ),
    ] = None
    job: ContactJob
    priority: Annotated[
        int | None,
        Field(description='As `?priority=`: larger goes first.', ge=-100, le=100),
    ] = None


class BatchOfJobs(BaseModel):
    """
    Jobs to hand in.
    """

    jobs: Annotated[
        list[BatchedJob],
        Field(
            description='The jobs, in the order in which they are queued.',
            max_length=100,
            min_length=1,
        ),
    ]
