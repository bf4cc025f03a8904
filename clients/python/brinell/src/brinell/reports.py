# Generated from api/openapi.json by clients/python/scripts/models.sh; do not edit.

from __future__ import annotations

from typing import Annotated, Literal

from brinell._model import BaseModel
from pydantic import Field, RootModel, StringConstraints
from typing_extensions import TypeAliasType


class AnswerPlace(BaseModel):
    """
    The place of a figure, in the coordinates of the arrays of its step.
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


class Course(BaseModel):
    """
    A figure of all passes.
    """

    error: Annotated[
        list[float | None],
        Field(
            description='Bounds of their relative errors by columns and length of the track; `null` where the pass on half the columns has no answer, and of a figure that is 0. Without unit.'
        ),
    ]
    value: Annotated[
        list[float], Field(description='Its values, in the unit of the row.')
    ]


class ErrorBar1(RootModel[float]):
    root: Annotated[
        float, Field(description='Bound of the relative error. Without unit.', ge=0.0)
    ]


class Fatigue(BaseModel):
    """
    Utilization over depth by criteria of high-cycle fatigue: the largest across the travel.
    """

    crossland: Annotated[
        list[float] | None,
        Field(
            description="By Crossland's criterion; `null` where it does not hold for the limits. Without unit."
        ),
    ]
    dang_van: Annotated[
        list[float] | None,
        Field(
            description="By Dang Van's criterion; `null` where it does not hold for the limits. Without unit."
        ),
    ]
    depth: Annotated[
        list[float],
        Field(description='Depth below the surface, from 0. Unit: mm (SI: m).'),
    ]
    orthogonal_shear: Annotated[
        list[float] | None,
        Field(
            description='By the amplitude of the shear stress along the surface. Without unit.'
        ),
    ]


class FatigueOfBodies(BaseModel):
    """
    One value for each body.
    """

    lower: Annotated[
        Fatigue | None,
        Field(
            description='Of the lower body; null if it is rigid or the step was stopped.'
        ),
    ]
    upper: Annotated[
        Fatigue | None,
        Field(
            description='Of the upper body; null if it is rigid or the step was stopped.'
        ),
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


class Looks(BaseModel):
    """
    Solved values of an input, the figure under each, and its relative error.
    """

    error: Annotated[
        list[float | None],
        Field(
            description='Bound of its relative error; `null` without one. Without unit.'
        ),
    ]
    figure: Annotated[list[float], Field(description='The figure.')]
    value: Annotated[list[float], Field(description='Values of the input.')]


class Cell(RootModel[int]):
    root: Annotated[int, Field(ge=0)]


class Mesh(BaseModel):
    """
    The mesh that was solved on.
    """

    cells: Annotated[
        list[Cell] | None,
        Field(
            description='Columns, rows and layers of the cells of half-spaces or of a track, 0 layers of elastic bodies; absent of meshes.'
        ),
    ] = None
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


class Iteration2(RootModel[int]):
    root: Annotated[int, Field(ge=0)]


class NumberItem(RootModel[int]):
    root: Annotated[int, Field(ge=0)]


class Passes(BaseModel):
    """
    The passes that have converged, one entry for each in every list; their figures under the names of rows.
    """

    contact: Annotated[
        dict[str, Course],
        Field(description='Figures of the contact and of both bodies.'),
    ]
    iterations: Annotated[list[Iteration2], Field(description='Iterations made.')]
    lower: Annotated[
        dict[str, Course],
        Field(
            description='What each pass leaves in the lower body; empty of one that cannot yield.'
        ),
    ]
    number: Annotated[
        list[NumberItem], Field(description='Number of the pass, from 1.')
    ]
    upper: Annotated[
        dict[str, Course],
        Field(
            description='What each pass leaves in the upper body; empty of one that cannot yield.'
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
    The plastic zone of one body.
    """

    outline: Annotated[
        list[list[OutlineItem]],
        Field(
            description='Outline of the plastic zone in the section x–y: closed polygons of points `[x, depth]`, the first one not repeated, both sides of the axis; none in three dimensions. Depth is counted downward from the plane in which the bodies first touch, into the material of either body. Counter-clockwise in the axes `(x, depth)`; holes clockwise. Unit: mm (SI: m).'
        ),
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


class PressureQuantiles(BaseModel):
    """
    The contact of heights: parts of the area in contact, and the pressure below which they are. Empty where nothing touches.
    """

    part: Annotated[
        list[float], Field(description='Parts of the area in contact. Without unit.')
    ]
    pressure: Annotated[
        list[float],
        Field(description='Pressure below which they are. Unit: MPa (SI: Pa).'),
    ]


class RollerContact(BaseModel):
    """
    The contact along a roller, in rows of cells across it. y is that of the fields, 0 in the middle of the roller.
    """

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
    pressure: Annotated[
        list[float],
        Field(
            description='Largest pressure of a cell of each row. Unit: MPa (SI: Pa).'
        ),
    ]
    y: Annotated[
        list[float],
        Field(description='Middles of the rows along the roller. Unit: mm (SI: m).'),
    ]


class ShakedownMap(BaseModel):
    """
    Hertz's peak pressures that a contact bears over the friction, of both bodies the lower.
    """

    elastic: Annotated[
        list[float],
        Field(
            description='Up to which nothing yields; empty of a load that does not roll. Unit: MPa (SI: Pa).'
        ),
    ]
    friction: Annotated[
        list[float],
        Field(description='Traction over pressure in the whole contact. Without unit.'),
    ]
    kinematic: Annotated[
        list[float],
        Field(
            description='Up to which bodies with kinematic hardening without bound shake down; empty of a load that does not roll. Unit: MPa (SI: Pa).'
        ),
    ]
    perfect: Annotated[
        list[float | None],
        Field(
            description='Up to which perfectly plastic bodies shake down; `null` of an ellipse that slides. Unit: MPa (SI: Pa).'
        ),
    ]
    perfect_depth: Annotated[
        list[float],
        Field(
            description='Depth that decides on `perfect`; empty of a load that rolls. Unit: mm (SI: m).'
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
        list[float],
        Field(
            description='x of the normal, along the arc for a pin in a hole; in three dimensions `[x, y]`. Unit: mm (SI: m).'
        ),
    ]
    sigma_x: Annotated[
        list[float],
        Field(
            description='Tangential stress; radial in axisymmetry. Unit: MPa (SI: Pa).'
        ),
    ]
    sigma_xx: Annotated[
        list[float] | None,
        Field(
            description='Stress along x, the shorter semi-axis of the contact. This and the following only in three dimensions, where `sigma_x` is `sigma_xx`, the normal stress `sigma_y` is `sigma_zz`, and `sigma_z` is `sigma_yy`. Unit: MPa (SI: Pa).'
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

    height: Annotated[
        list[float],
        Field(
            description='How far each has moved outward from the undeformed surface; a dent is negative. Unit: mm (SI: m).'
        ),
    ]
    x: Annotated[
        list[float],
        Field(
            description='x of the nodes, both sides of the axis; arc lengths for a pin in a hole. Unit: mm (SI: m).'
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


class Tolerances(BaseModel):
    """
    What tolerances of inputs do to the rows of the result that have a value: a list with one entry for each row.
    """

    at_worst: Annotated[
        list[float | None],
        Field(
            description='Relative change where all tolerances add up, each in the sense that changes it more; `null` where the figure is not known beside it. Without unit.'
        ),
    ]
    body: Annotated[
        list[Literal['upper', 'lower', 'both'] | None],
        Field(description='Their bodies.'),
    ]
    elasticities: Annotated[
        list[list[float | None]],
        Field(
            description='Relative change of the figure over that of each input; `null` where the figure is not known beside it. Without unit.'
        ),
    ]
    error: Annotated[
        list[float | None],
        Field(
            description='Bounds of their relative errors by mesh and increments; `null` without one. Without unit.'
        ),
    ]
    inputs: Annotated[list[str], Field(description='JSON pointers of the inputs.')]
    label: Annotated[list[str], Field(description='Their names for a person.')]
    name: Annotated[list[str], Field(description='Names of the rows.')]
    relative: Annotated[
        list[float],
        Field(description='Their relative tolerances, to either side. Without unit.'),
    ]
    root_of_squares: Annotated[
        list[float | None],
        Field(
            description='Root of the sum of the squares of their changes. Without unit.'
        ),
    ]
    text: Annotated[
        str, Field(description='Which input matters most, in one sentence.')
    ]


class ValidityNote(BaseModel):
    """
    One remark on the validity of the answer.
    """

    code: Annotated[
        str,
        Field(
            description='Stable identifier. There may be more in the future.',
            examples=['not_converged', 'cancelled', 'timed_out', 'slow_coupling', 'wide_contact', 'collapse', 'large_strain', 'deformation_theory', 'falling_loads', 'no_contact', 'sharp_corner', 'contact_at_edge', 'coarse_mesh', 'unbounded_strain', 'accuracy_missed', 'bilinear_curve', 'onset_unknown', 'yield_by_hardness', 'initial_yield', 'coarse_case', 'near_support', 'half_spaces', 'roller_end', 'surface_end', 'near_limit', 'fatigue', 'fatigue_by_hardness', 'full_sliding', 'inclined_pressure', 'suspicious_units', 'suspicious_curve', 'suspicious_profile', 'suspicious_heights', 'bias_unknown', 'outside_scale', 'no_dent', 'thin_specimen', 'narrow_specimen', 'blunt_tip', 'equal_cone'],
        ),
    ]
    message: Annotated[str, Field(description='For a person.')]


class AnswerAt(BaseModel):
    """
    Of which part of the step, or of which load of the job, a row is.
    """

    criterion: Annotated[
        Literal['dang_van', 'crossland', 'orthogonal_shear'] | None,
        Field(description='The criterion of fatigue.'),
    ] = None
    hardening: Annotated[
        Literal['given', 'isotropic', 'kinematic'] | None,
        Field(description='The rule of hardening, where two were solved.'),
    ] = None
    load: Annotated[int | None, Field(description='The load, from 1.', ge=0)] = None
    pass_: Annotated[
        int | None,
        Field(alias='pass', description='The pass of a load that rolls, from 1.', ge=0),
    ] = None


class Contact(BaseModel):
    """
    The contact over the surface.
    """

    along: Annotated[
        RollerContact | None, Field(description='The rows of cells along a roller.')
    ] = None
    maps: Annotated[
        ContactMaps | None,
        Field(
            description='Pressure, gap and dent of all cells, in three dimensions; absent unless `output.fields` asks for them.'
        ),
    ] = None
    nodes: Annotated[
        ContactNodes,
        Field(
            description='The candidate pairs in order of x; in three dimensions the cells of the section y = 0.'
        ),
    ]
    patches: Annotated[
        list[Patch],
        Field(description='The connected parts of the contact, from left to right.'),
    ]
    quantiles: Annotated[
        PressureQuantiles | None,
        Field(description='How the pressure of heights is spread.'),
    ] = None
    section: Annotated[
        ContactSection | None,
        Field(description='The cells of the section x = 0, in three dimensions.'),
    ] = None


class Found(BaseModel):
    """
    The input with which a figure is as wanted: the row `input_found` of `answers`. The steps are those of the job with it.
    """

    figure: Annotated[str, Field(description='Name of the figure.')]
    looks: Annotated[
        Looks,
        Field(description='The jobs that were solved, in the order of their values.'),
    ]
    text: Annotated[str, Field(description='The answer in one sentence.')]
    values: Annotated[
        list[float],
        Field(
            description='Values between the ends with which it is as wanted, that of this result first. Unit: that of `input_found`.'
        ),
    ]
    vary: Annotated[
        list[str], Field(description='JSON pointers of the numbers that were varied.')
    ]


class RuleVerdict(BaseModel):
    """
    The verdict on a track by one rule of hardening; its figures are the rows `strain_per_pass`.
    """

    hardening: Annotated[
        Literal['given', 'isotropic', 'kinematic'], Field(description='The rule.')
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
    The verdict on a load step, made of its rows.
    """

    body: Literal['upper', 'lower', 'both'] | None
    figure: Annotated[
        str | None,
        Field(
            description='Name of the row that decides, and at whose `place` pictures open; `null` without an answer.'
        ),
    ]
    level: Annotated[
        str,
        Field(
            description='The state of the bodies.',
            examples=['not_converged', 'collapse', 'above_shakedown_limit', 'ratchets', 'closed_cycle', 'shakes_down', 'yields', 'dented', 'elastic', 'not_known', 'no_contact'],
        ),
    ]
    mark: Annotated[
        Literal['good', 'attention', 'bad', 'unknown'],
        Field(description='How the state is marked.'),
    ]
    text: Annotated[str, Field(description='One sentence for a person.')]


class Answer(BaseModel):
    """
    One figure, made to be shown.
    """

    at: Annotated[
        AnswerAt | None,
        Field(
            description='Of which pass, rule of hardening, criterion or load it is; absent of the step as it ends.'
        ),
    ] = None
    at_least: Annotated[
        float | None,
        Field(
            description='What a figure without a bound of its error is at least. Unit: `unit`.'
        ),
    ] = None
    at_most: Annotated[
        float | None,
        Field(
            description='What a figure without a bound of its error is at most, one below zero by its size. Unit: `unit`.'
        ),
    ] = None
    body: Literal['upper', 'lower', 'both'] | None
    detail: Annotated[
        bool,
        Field(description='Whether it stands behind the figures that answer the job.'),
    ]
    elastic: Annotated[
        float | None,
        Field(description="The figure by Hertz's elastic theory, where that has one."),
    ]
    error: Annotated[
        ErrorBar1 | Literal['given', 'exact', 'not_bounded'],
        Field(
            description='Estimated bound of its relative error by mesh and increments, or a word.'
        ),
    ]
    label: Annotated[str, Field(description='Name for a person.')]
    name: Annotated[
        str,
        Field(
            description='Stable identifier, such as `peak_pressure`. Name, `body` and `at` identify a row.'
        ),
    ]
    place: AnswerPlace | None
    quantity: Annotated[
        str,
        Field(
            description='Its physical quantity. A `strain` and a `ratio` are shown in per cent.',
            examples=['length', 'area', 'volume', 'stress', 'force', 'line_force', 'stiffness', 'line_stiffness', 'energy', 'line_energy', 'strain', 'ratio', 'number', 'angle', 'degrees'],
        ),
    ]
    reason: Annotated[
        str | None,
        Field(
            description='Why the error is not bounded; absent beside any other error.'
        ),
    ] = None
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
            description='The figure in `unit`; `null` where it is not known, and `reason` says why.'
        ),
    ]


class Step(BaseModel):
    """
    One load step.
    """

    answers: Annotated[
        list[Answer],
        Field(
            description='The figures of the step: those that answer the job, in the order in which it asks for them, and behind them details. Empty of a step that was stopped.'
        ),
    ]
    contact: Annotated[Contact, Field(description='The contact over the surface.')]
    fatigue: Annotated[
        FatigueOfBodies | None,
        Field(
            description='Utilization over depth by criteria of high-cycle fatigue, of a load that rolls after its last pass by the rule of hardening of its verdict; absent without limits of fatigue, `null` of a body without, and where it is not known.'
        ),
    ] = None
    fields: Annotated[
        FieldsOfBodies | None,
        Field(description='Mesh and nodal fields; absent unless asked for.'),
    ] = None
    history: Annotated[list[Iteration1], Field(description='Every outer iteration.')]
    increments: Annotated[
        Increments | None,
        Field(description='The increments of this load, under flow theory.'),
    ] = None
    layers: Annotated[
        LayersOfBodies | None,
        Field(
            description='Stresses and plastic strain in the layers of half-spaces in three dimensions, which have no mesh; absent unless `output.fields` asks for them.'
        ),
    ] = None
    load: Annotated[
        PrescribedForce | PrescribedApproach, Field(description='What was prescribed.')
    ]
    passes: Annotated[
        Passes | None, Field(description='The passes of a load that rolls.')
    ] = None
    plasticity: Annotated[
        PlasticZoneOfBodies,
        Field(description='Plastic zone of each body; `null` for a rigid one.'),
    ]
    rules: Annotated[
        list[RuleVerdict] | None,
        Field(
            description='The verdicts on a track by each rule of hardening that was solved.'
        ),
    ] = None
    shakedown: Annotated[
        ShakedownMap | None,
        Field(
            description="Hertz's peak pressures that the contact bears over the friction as it rolls, where strength and shapes have closed forms."
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
    surfaces: Annotated[
        SurfaceOfBodies | None,
        Field(
            description='The surface of each body near the contact, under flow theory.'
        ),
    ] = None
    validity: Annotated[
        list[ValidityNote], Field(description='What to keep in mind about this answer.')
    ]
    verdict: Annotated[
        Verdict, Field(description='The state of the bodies in one sentence.')
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
    answers: Annotated[
        list[Answer] | None,
        Field(
            description='The figures that follow from more than one load: of a hardness test, and the sensitivity of a target.'
        ),
    ] = None
    found: Annotated[
        Found | None, Field(description='The input that the job asks for.')
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
    theory: Annotated[
        str | None,
        Field(
            description='Theory of plasticity, `flow` or `deformation`; `null` where no body can yield.'
        ),
    ]
    timings_ms: Annotated[Timings, Field(description='Where the time went.')]
    tolerances: Annotated[
        Tolerances | None,
        Field(description='What tolerances of inputs do to the figures.'),
    ] = None
    units: Annotated[
        Literal['mm_N_MPa', 'SI'],
        Field(
            description='Units of every figure of the job and of its result: mm, N, MPa or m, N, Pa.'
        ),
    ]
    validity: Annotated[
        list[ValidityNote] | None,
        Field(
            description='What to keep in mind about figures that follow from more than one load.'
        ),
    ] = None
    version: Annotated[str, Field(description='Version of the program.')]
