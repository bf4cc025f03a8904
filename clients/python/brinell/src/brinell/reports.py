# Generated from api/openapi.json by clients/python/scripts/models.sh; do not edit.

from __future__ import annotations

from typing import Annotated, Literal

from brinell._model import BaseModel
from pydantic import Field, RootModel, StringConstraints
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
    pile_up: Annotated[
        float | None,
        Field(description='Of the pile-up beside the groove. Without unit.', ge=0.0),
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


class ValidityNote(BaseModel):
    """
    One remark on the validity of the answer.
    """

    code: Annotated[
        str,
        Field(
            description='Stable identifier. There may be more in the future.',
            examples=['not_converged', 'cancelled', 'timed_out', 'slow_coupling', 'wide_contact', 'collapse', 'large_strain', 'deformation_theory', 'falling_loads', 'no_contact', 'sharp_corner', 'contact_at_edge', 'coarse_mesh', 'unbounded_strain', 'bilinear_curve', 'onset_unknown', 'yield_by_hardness', 'initial_yield', 'coarse_case', 'near_support', 'half_spaces', 'roller_end', 'surface_end', 'near_limit', 'full_sliding', 'inclined_pressure', 'suspicious_units', 'suspicious_curve', 'suspicious_profile', 'suspicious_heights', 'bias_unknown', 'outside_scale', 'no_dent', 'thin_specimen', 'narrow_specimen', 'blunt_tip', 'equal_cone'],
        ),
    ]
    message: Annotated[str, Field(description='For a person.')]


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

    at_least: Annotated[
        float | None,
        Field(description='What a figure without an error is at least. Unit: `unit`.'),
    ] = None
    at_most: Annotated[
        float | None,
        Field(
            description='What a figure without an error is at most, one below zero by its size. Unit: `unit`.'
        ),
    ] = None
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
        float | None,
        Field(
            description='Pressure in the middle of the contact; of a roller the largest across its middle, `null` of heights. Unit: MPa (SI: Pa).',
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


class RuleVerdict(BaseModel):
    """
    The verdict on a track by one rule of hardening.
    """

    hardening: Annotated[
        Literal['given', 'isotropic', 'kinematic'], Field(description='The rule.')
    ]
    passes: Annotated[int, Field(description='Passes that have converged.', ge=0)]
    rate: Annotated[
        float | None, Field(description='As `rate` of the track. Without unit.', ge=0.0)
    ]
    rate_error: Annotated[
        float | None,
        Field(description='As `rate_error` of the track. Without unit.', ge=0.0),
    ]
    reason: Annotated[
        str | None,
        Field(
            description='Why the verdict is open or the passes end; `null` otherwise.'
        ),
    ]
    verdict: Annotated[
        Literal['elastic', 'shakes_down', 'closed_cycle', 'undecided', 'ratchets'],
        Field(description='What becomes of the track, of both bodies the worse.'),
    ]


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
            description='Plastic strain of a steady pass, or of a pair of passes there and back: net strain of a track that ratchets, accumulated strain of one that closes a cycle, 0 of one that shakes down; `null` where it is undecided. Where the first layer decides it is that of the surface, by √z from the first two layers. Without unit.',
            ge=0.0,
        ),
    ]
    rate_depth: Annotated[
        float | None,
        Field(
            description='Depth of the rate, 0 at the surface; `null` where there is none. Unit: mm (SI: m).',
            ge=0.0,
        ),
    ]
    rate_error: Annotated[
        float | None,
        Field(
            description='Estimated error of the rate by columns, and its change over three passes; of the surface at least the difference to the first layer. Without unit.',
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
    rules: Annotated[
        list[RuleVerdict] | None,
        Field(
            description='The verdicts by each rule of hardening that was solved. `verdict` is the worst of them.'
        ),
    ] = None
    verdict: Annotated[
        Literal['elastic', 'shakes_down', 'closed_cycle', 'undecided', 'ratchets'],
        Field(description='What becomes of the track, of both bodies the worse.'),
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
    theory: Annotated[
        str | None,
        Field(
            description='Theory of plasticity, `flow` or `deformation`; `null` where no body can yield.'
        ),
    ]
    timings_ms: Annotated[Timings, Field(description='Where the time went.')]
    units: Annotated[
        Literal['mm_N_MPa', 'SI'],
        Field(
            description='Units of every figure of the job and of its result: mm, N, MPa or m, N, Pa.'
        ),
    ]
    version: Annotated[str, Field(description='Version of the program.')]
