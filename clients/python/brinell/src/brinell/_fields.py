"""Mesh and stresses of a step as arrays.

docs/results.md describes the archive that the service sends.
"""

from __future__ import annotations

import io
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ._plain import need

if TYPE_CHECKING:
    import pyvista
    import xarray as xr

Array = NDArray[Any]


def decode(data: bytes) -> dict[str, dict[str, Array]]:
    """The arrays of each body, by their names: those of an `.npz` archive."""
    bodies: dict[str, dict[str, Array]] = {}
    with np.load(io.BytesIO(data)) as archive:
        for name, values in archive.items():
            body, array = name.split("/")
            bodies.setdefault(body, {})[array] = values
    return bodies


@dataclass(frozen=True)
class BodyFields(Mapping[str, Array]):
    """Mesh and stresses of one body, a mapping of names to arrays.

    `y` points from the lower body to the upper.
    """

    name: str
    """`upper` or `lower`."""
    arrays: Mapping[str, Array]
    symmetric: bool
    """Whether one half, x ≥ 0, stands for both."""

    def __getitem__(self, name: str) -> Array:
        try:
            return self.arrays[name]
        except KeyError:
            raise KeyError(f"no field {name!r}; there are {', '.join(self.arrays)}") from None

    def __iter__(self) -> Any:
        return iter(self.arrays)

    def __len__(self) -> int:
        return len(self.arrays)

    def __repr__(self) -> str:
        return f"<{self.name} body: {len(self['nodes'])} nodes, {', '.join(self.arrays)}>"

    @property
    def nodes(self) -> Array:
        """Nodes before loading, a row [x, y] each."""
        return self["nodes"]

    @property
    def elements(self) -> Array:
        """The four corners of each element, counter-clockwise."""
        return self["elements"]

    @property
    def displacement(self) -> Array:
        """Displacements of the nodes, relative to the body's own support."""
        return self["displacement"]

    def whole(self) -> BodyFields:
        """Both halves of a body of which one was meshed."""
        if not self.symmetric:
            return self
        count = len(self.nodes)
        odd = {"tau_xy": -1.0}
        arrays: dict[str, Array] = {}
        for name, values in self.arrays.items():
            if name == "elements":
                # The mirror image turns the other way round.
                arrays[name] = np.concatenate([values, values[:, ::-1] + count])
            elif values.ndim == 2:
                arrays[name] = np.concatenate(
                    [values, values * np.array([-1.0, 1.0], values.dtype)]
                )
            else:
                arrays[name] = np.concatenate(
                    [values, values * values.dtype.type(odd.get(name, 1.0))]
                )
        return BodyFields(self.name, arrays, False)

    def to_xarray(self) -> xr.Dataset:
        """The fields over the nodes, whose places are `x` and `y`, with the corners of each
        element; layers of three dimensions over `z`, `x` and `y`.
        """
        xarray = need("xarray", "pandas")
        if "nodes" not in self.arrays:
            axes = {axis: self.arrays[axis] for axis in "zxy"}
            values = {n: (tuple(axes), v) for n, v in self.arrays.items() if n not in axes}
            layers: xr.Dataset = xarray.Dataset(values, coords=axes)
            return layers
        dims = {"elements": ("element", "corner"), "displacement": ("node", "component")}
        values = {n: (dims.get(n, ("node",)), v) for n, v in self.arrays.items() if n != "nodes"}
        places = {"x": ("node", self.nodes[:, 0]), "y": ("node", self.nodes[:, 1])}
        data: xr.Dataset = xarray.Dataset(values, coords={**places, "component": ["x", "y"]})
        return data

    def to_pyvista(self) -> pyvista.UnstructuredGrid:
        """The mesh with its fields for PyVista."""
        kit = need("pyvista", "fields")
        elements = self.elements.astype(np.int64)
        cells = np.column_stack([np.full(len(elements), 4), elements]).ravel()
        flat = np.zeros((len(self.nodes), 1))
        grid: pyvista.UnstructuredGrid = kit.UnstructuredGrid(
            cells,
            np.full(len(elements), kit.CellType.QUAD, np.uint8),
            np.hstack([self.nodes.astype(float), flat]),
        )
        for name, values in self.arrays.items():
            if name not in ("nodes", "elements"):
                grid.point_data[name] = np.hstack([values, flat]) if values.ndim == 2 else values
        return grid


@dataclass(frozen=True)
class Fields:
    """Mesh and stresses of a step. A rigid body has none."""

    upper: BodyFields | None
    lower: BodyFields | None

    @classmethod
    def of(cls, data: bytes, symmetric: bool) -> Fields:
        """From what the service sends."""
        bodies = decode(data)
        upper, lower = (
            BodyFields(name, bodies[name], symmetric) if name in bodies else None
            for name in ("upper", "lower")
        )
        return cls(upper, lower)

    @property
    def bodies(self) -> list[BodyFields]:
        """The bodies that have fields."""
        return [body for body in (self.upper, self.lower) if body is not None]

    def to_xarray(self) -> xr.DataTree:
        """Both bodies, as in `tree["lower/von_mises"]`."""
        parts = {body.name: body.to_xarray() for body in self.bodies}
        tree: xr.DataTree = need("xarray", "pandas").DataTree.from_dict(parts)
        return tree

    def to_pyvista(self) -> pyvista.MultiBlock:
        """Both bodies for PyVista."""
        blocks = {body.name: body.to_pyvista() for body in self.bodies}
        made: pyvista.MultiBlock = need("pyvista", "fields").MultiBlock(blocks)
        return made
