"""Measured surfaces: read with their units, holes named, levelled, thinned to what a job takes."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal, TypeAlias

import numpy as np

from ._arrays import Floats, grid_of
from ._errors import Fault, InvalidJob
from ._grid_text import NotUnderstood, grid_of_points, read_grid
from ._lengths import length_in_mm
from ._plain import Number, Quantity, grouped, need

MOST = 512
"""Most heights along a side of a surface on a body that yields."""
MOST_ELASTIC = 1024
"""Most heights along a side where neither body yields."""

# Figures that programs put where nothing was measured.
_KNOWN = (-9999.0, 9999.0, -99999.0, 99999.0, -32768.0, 32767.0, 65535.0, -1e30, 1e30)
# How many times as far as all others reach a figure is away that is no height.
_FAR = 1e4
# How often one figure stands apart that may be no height.
_SEVERAL = 3

Pair: TypeAlias = Number | Sequence[Number]
Level: TypeAlias = Literal["mean", "plane", "paraboloid"]


@dataclass(frozen=True, eq=False)
class Surface:
    """Heights on a grid in mm, as a body of a job takes them: `"surface": surface`."""

    heights: Floats
    """Heights outward, `[i, j]` at the i-th x and the j-th y [mm]; NaN in holes."""
    spacing: tuple[float, float]
    """Distances of heights along x and y [mm]."""
    notes: tuple[str, ...] = ()
    """What was read, taken for granted, changed and lost."""

    @property
    def missing(self) -> int:
        """How many heights are missing."""
        return int(np.count_nonzero(~np.isfinite(self.heights)))

    @property
    def size(self) -> tuple[float, float]:
        """Sides of the patch along x and y [mm]."""
        (nx, ny), (dx, dy) = self.heights.shape, self.spacing
        return nx * dx, ny * dy

    @property
    def rms_height(self) -> float:
        """Sq: root mean square of the heights above their mean plane [mm]."""
        return float(np.sqrt(np.nanmean(self._above("plane") ** 2)))

    @property
    def rms_slope(self) -> float:
        """Sdq: root mean square of the slope, by differences of neighbours."""
        flat = self._above("plane")
        squares = [
            np.nanmean((np.diff(flat, axis=axis) / step) ** 2)
            for axis, step in enumerate(self.spacing)
        ]
        return float(np.sqrt(sum(squares)))

    def filled(self, how: str = "harmonic") -> Surface:
        """The same with its holes filled.

        `"harmonic"`: each missing height is the mean of its neighbours, as of a skin stretched
        over the hole from its rim. Nothing is known of what lies in a hole.
        """
        if how != "harmonic":
            raise ValueError(f'holes are filled by fill="harmonic", not {how!r}')
        count = self.missing
        if not count:
            return self
        note = f"{grouped(count)} of {grouped(self.heights.size)} heights filled in, harmonic"
        return self._with(_harmonic(self.heights), note)

    def levelled(self, by: Level = "plane") -> Surface:
        """The same less its least-squares `"plane"`, `"paraboloid"` or its `"mean"`."""
        if by not in ("mean", "plane", "paraboloid"):
            raise ValueError(f'level is "mean", "plane" or "paraboloid", not {by!r}')
        return self._with(self._above(by), f"levelled: the {by} is taken away")

    def resampled(
        self, size: int | Sequence[int] | None = None, cell: Pair | None = None
    ) -> Surface:
        """The same with fewer heights, each the mean over its new cell.

        `size`: how many heights, along both sides or the longer one. `cell`: the new distances,
        from the middle of the map outward; what is no whole cell at the rim falls away.
        """
        if (size is None) == (cell is None):
            raise ValueError("either size or cell")
        old, sides = self.spacing, self.size
        counts: Sequence[int]
        if size is not None:
            if isinstance(size, int):
                # Cells stay as they are in proportion.
                times = max(max(self.heights.shape) / size, 1.0)
                counts = [max(round(count / times), 1) for count in self.heights.shape]
            else:
                counts = [int(one) for one in size]
            new = [side / count for side, count in zip(sides, counts, strict=True)]
        else:
            new = list(_pair(cell, "cell"))
            counts = [int(side / one * (1 + 1e-9)) for side, one in zip(sides, new, strict=True)]
        if any(a < b * (1 - 1e-9) for a, b in zip(new, old, strict=True)):
            raise ValueError(
                f"cells of {_words(new)} are finer than those measured, {_words(old)}: nothing is "
                "known between these"
            )
        if min(counts) < 1:
            raise ValueError(f"cells of {_words(new)} on a map of {_words(sides)}")
        if tuple(counts) == self.heights.shape and size is not None:
            return self
        heights = self.heights
        for axis in (0, 1):
            heights = _means(heights, axis, new[axis] / old[axis], counts[axis])
        coarse = replace(self, heights=heights, spacing=(new[0], new[1]))
        (nx, ny), (mx, my) = self.heights.shape, heights.shape
        note = (
            f"{nx} × {ny} heights thinned to {mx} × {my}, each the mean of its cell of "
            f"{_words(new)}: Sq from {_micro(self.rms_height)} to {_micro(coarse.rms_height)}, "
            f"slope Sdq from {self.rms_slope:.3g} to {coarse.rms_slope:.3g} "
            f"({_part(self.rms_slope, coarse.rms_slope)} of it lost)"
        )
        return replace(coarse, notes=(*self.notes, note))

    def cropped(self, size: int | Sequence[int]) -> Surface:
        """The middle of the map, of this many heights along both sides."""
        wanted = [size, size] if isinstance(size, int) else list(size)
        counts = [min(a, b) for a, b in zip(wanted, self.heights.shape, strict=True)]
        starts = [(n - m) // 2 for n, m in zip(self.heights.shape, counts, strict=True)]
        (i, j), (nx, ny) = starts, counts
        note = (
            f"the middle {nx} × {ny} of {self.heights.shape[0]} × {self.heights.shape[1]} heights"
        )
        return self._with(self.heights[i : i + nx, j : j + ny], note)

    def in_job(self, unit: str) -> dict[str, Any]:
        """The surface as a job takes it, lengths in this unit."""
        factor = 1 / length_in_mm(unit)
        return {
            "heights": self.heights * factor,
            "spacing_x": self.spacing[0] * factor,
            "spacing_y": self.spacing[1] * factor,
        }

    def _above(self, by: str) -> Floats:
        """Heights above the mean, plane or paraboloid of least squares."""
        if by == "mean":
            centred: Floats = self.heights - np.nanmean(self.heights)
            return centred
        x, y = np.meshgrid(*(np.linspace(-1, 1, n) for n in self.heights.shape), indexing="ij")
        terms = [np.ones_like(x), x, y]
        if by == "paraboloid":
            terms += [x * x, x * y, y * y]
        design = np.stack(terms, axis=-1)
        known = np.isfinite(self.heights)
        normal = design[known].T @ design[known]
        found = np.linalg.lstsq(normal, design[known].T @ self.heights[known], rcond=None)[0]
        above: Floats = self.heights - design @ found
        return above

    def _with(self, heights: Floats, note: str) -> Surface:
        return replace(self, heights=heights, notes=(*self.notes, note))

    def __repr__(self) -> str:
        (nx, ny), lines = self.heights.shape, [f"- {note}" for note in self.notes]
        head = f"Surface of {nx} × {ny} heights, cells of {_words(self.spacing)}"
        if self.missing == self.heights.size:
            return f"{head}, none of them known"
        figures = f"Sq {_micro(self.rms_height)}, Sdq {self.rms_slope:.3g}"
        return "\n".join([f"{head}; {figures}", *lines])


def surface(
    source: Any,
    *,
    spacing: Pair | None = None,
    unit: str | None = None,
    height_unit: str | None = None,
    no_data: float | Iterable[float] | None = (),
    fill: Literal["harmonic"] | None = None,
    level: Level | None = None,
    size: int | Sequence[int] | None = None,
    cell: Pair | None = None,
    channel: int | str | None = None,
    skip: Iterable[int] = (),
) -> Surface:
    """A measured surface for a body of a job in three dimensions.

    Args:
        source: a topography of SurfaceTopography, an array of numpy (masked or not), pandas or
            xarray, or the name of a file: text grids of Gwyddion, Surfer and ESRI, lists of x, y
            and z, `.npy`, and what SurfaceTopography reads (`pip install "brinell[surfaces]"`).
            `[i, j]` is the i-th x and the j-th y.
        spacing: distance of heights, or two along x and y, where the source brings none: in
            `unit`, or quantities.
        unit: unit of lengths ("mm", "µm", "nm", "m", …) where the source says none; arrays of
            numpy are in mm.
        height_unit: unit of the heights alone, if it is another.
        no_data: figures that stand for no height, such as -9999. `None`: all are heights.
        fill: "harmonic" fills holes from their rims; without it they are named, and a job with
            them is refused.
        level: takes away the "mean", the least-squares "plane" or the "paraboloid".
        size: thins to this many heights along the longer side, or along both.
        cell: thins to these distances of heights [mm].
        channel: name or number of the channel of a file that has several of heights.
        skip: numbers of header lines of a text that are left out.

    Raises:
        InvalidJob: the source lacks a unit or a distance, has figures that are no heights, or is
            not understood; each fault is named.
    """
    made = _made(_read(source, spacing, unit, height_unit, channel, tuple(skip)), no_data)
    if made.missing and not fill:
        i, j = np.argwhere(~np.isfinite(made.heights))[0]
        made = replace(
            made,
            notes=(
                *made.notes,
                f"{grouped(made.missing)} of {grouped(made.heights.size)} heights are missing, "
                f'the first at [{i}, {j}]; fill="harmonic" fills them',
            ),
        )
    if fill:
        made = made.filled(fill)
    if level:
        made = made.levelled(level)
    if size is not None or cell is not None:
        made = made.resampled(size, cell)
    if max(made.heights.shape) > MOST:
        nx, ny = made.heights.shape
        note = (
            f"{nx} × {ny} heights: a job takes {MOST} along a side where a body yields, and "
            f"{MOST_ELASTIC} where none does; size={MOST} thins them, .cropped({MOST}) keeps the "
            "middle"
        )
        made = replace(made, notes=(*made.notes, note))
    return made


# What instruments measure: a height every 10 mm at most, and a mean slope (Sdq) from that of a
# mirror of a telescope, nm over dm, to that of needles.
_LARGEST_STEP, _SLOPES = 10.0, (1e-6, 100.0)
_SCALED = (
    "The heights alone are taken with distances of your own: "
    "brinell.surface(heights, spacing=..., unit=...)"
)


def _refuse(kind: str, detail: str) -> InvalidJob:
    return InvalidJob([Fault("#/surface", kind, detail)], "not taken as a surface")


def _read(
    source: Any,
    spacing: Pair | None,
    unit: str | None,
    height_unit: str | None,
    channel: int | str | None,
    skip: tuple[int, ...],
) -> _Raw:
    if isinstance(source, Surface):
        return _Raw(source.heights, source.spacing, "mm", "mm", list(source.notes))
    if isinstance(source, (str, os.PathLike)):
        return _read_file(Path(source), spacing, unit, height_unit, channel, skip)
    if hasattr(source, "physical_sizes") and hasattr(source, "heights"):
        return _of_topography(source, spacing, unit)
    if hasattr(source, "data_vars"):
        names = [name for name, one in source.data_vars.items() if one.ndim == 2]
        wanted = channel if channel is not None else names[0] if len(names) == 1 else None
        if wanted not in names:
            said = ", ".join(map(str, names)) or "none"
            raise _refuse("missing", f"channel has to be one of the maps of the data set: {said}")
        return _of_xarray(source[wanted], spacing, unit, height_unit)
    if hasattr(source, "coords") and hasattr(source, "dims"):
        return _of_xarray(source, spacing, unit, height_unit)
    if isinstance(source, Quantity):
        return _Raw(source.to("mm").magnitude, spacing, unit or "mm", "mm", [])
    if hasattr(source, "index") and hasattr(source, "columns"):
        return _of_table(source, spacing, unit, height_unit)
    return _Raw(source, spacing, unit or "mm", height_unit or unit or "mm", [])


@dataclass
class _Raw:
    """Heights in the figures of their source."""

    heights: Any
    spacing: Any
    across: str | None
    up: str | None
    notes: list[str]


def _made(raw: _Raw, no_data: float | Iterable[float] | None) -> Surface:
    """A surface of heights whose units are known; names all that is not."""
    array, spacing, across, up = grid_of(raw.heights), raw.spacing, raw.across, raw.up
    points = array.ndim == 2 and array.shape[1] == 3 and array.shape[0] > 3
    if points:
        # No grid of a job is three heights wide.
        if spacing is not None:
            raise _refuse("inconsistent", "spacing is given, and points x, y, z bring it")
        try:
            grid = grid_of_points(array)
        except NotUnderstood as error:
            raise _refuse("not_understood", str(error)) from None
        array, spacing = grid.heights, grid.spacing
        raw.notes += grid.notes
    lacking = []
    if array.ndim != 2 or min(array.shape) < 2:
        lacking.append(f"heights are an array of two dimensions, not {array.shape}")
    if not across:
        lacking.append('it says no unit of its distances: unit="µm", say')
    if not up:
        lacking.append('it says no unit of its heights: height_unit="nm", say')
    if spacing is None:
        lacking.append("it says no distance of its heights: spacing=0.5, say, in `unit`")
    if lacking:
        faults = [Fault("#/surface", "missing", detail) for detail in lacking]
        raise InvalidJob(faults, "not taken as a surface")
    dx, dy = _pair(spacing, "spacing", length_in_mm(str(across)))
    array, notes = _without_no_data(array, no_data, str(up))
    array = array * length_in_mm(str(up))
    array = np.where(np.isfinite(array), array, np.nan)
    return Surface(array, (dx, dy), (*raw.notes, *notes))


def _pair(value: Any, name: str, factor: float = 1.0) -> tuple[float, float]:
    """Two lengths in mm."""
    single = isinstance(value, (int, float, np.number)) or (
        isinstance(value, Quantity) and np.ndim(value.magnitude) == 0
    )
    both = [value, value] if single else list(value)
    if len(both) != 2:
        raise _refuse("invalid", f"{name} is one length or two, along x and y, not {value!r}")
    found = [
        float(one.to("mm").magnitude) if isinstance(one, Quantity) else float(one) * factor
        for one in both
    ]
    if not (min(found) > 0 and np.isfinite(found).all()):
        raise _refuse("invalid", f"{name} has to be positive, not {value!r}")
    return found[0], found[1]


def _read_file(
    path: Path,
    spacing: Pair | None,
    unit: str | None,
    height_unit: str | None,
    channel: int | str | None,
    skip: tuple[int, ...],
) -> _Raw:
    data = path.read_bytes()
    if data[:6] == b"\x93NUMPY":
        array = np.load(path, allow_pickle=False)
        return _Raw(array, spacing, unit, height_unit or unit, [])
    text = _text_of(data)
    if text is not None and not text.lstrip().lower().startswith(("aiso-", "abcr-")):
        try:
            grid = read_grid(text, skip)
        except NotUnderstood as error:
            raise _refuse("not_understood", f"{path.name}: {error}") from None
        for name, said, given in (
            ("unit", grid.across, unit),
            ("height_unit", grid.up, height_unit),
        ):
            if said and given and length_in_mm(said) != length_in_mm(given):
                raise _refuse("inconsistent", f"{name}={given!r}, and {path.name} says {said!r}")
        if grid.spacing and spacing is not None:
            raise _refuse("inconsistent", f"spacing is given, and {path.name} says it")
        return _Raw(
            grid.heights,
            grid.spacing or spacing,
            grid.across or unit,
            grid.up or height_unit or unit,
            grid.notes,
        )
    return _of_instrument(path, spacing, unit, height_unit, channel)


def _text_of(data: bytes) -> str | None:
    """The text of a file, unless it is none."""
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return data.decode("utf-16", errors="replace")
    if b"\0" in data:
        first, second = data[:2000:2], data[1:2000:2]
        order = "utf-16-le" if not any(second) else "utf-16-be" if not any(first) else None
        if order is None:
            return None
        data = data.decode(order, errors="replace").encode()
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("cp1252", errors="replace")
    strange = sum(1 for sign in text[:2000] if ord(sign) < 32 and sign not in "\t\r\n\f\x1a")
    return None if strange else text


def _of_instrument(
    path: Path,
    spacing: Pair | None,
    unit: str | None,
    height_unit: str | None,
    channel: int | str | None,
) -> _Raw:
    library = need("SurfaceTopography", "surfaces")
    unknown = need("SurfaceTopography.Exceptions", "surfaces").CannotDetectFileFormat

    try:
        reader = library.open_topography(str(path))
    except unknown:
        if path.suffix in (".nc", ".nc4", ".cdf", ".h5"):
            data = need("xarray", "surfaces").open_dataset(path)
            return _read(data, spacing, unit, height_unit, channel, ())
        raise _refuse("not_understood", f"no format known here reads {path.name}") from None
    if reader.format() in ("asc", "matrix", "xyz"):
        raise _refuse("not_understood", f"{path.name} has signs in it that are no text")
    channels = [one for one in reader.channels if one.is_height_channel and one.dim == 2]
    if not channels:
        said = ", ".join(f"{one.name} ({one.data_unit})" for one in reader.channels)
        raise _refuse("missing", f"{path.name} has no map of heights, but {said or 'nothing'}")
    names = [one.name for one in channels]
    if channel is None:
        chosen = channels[0]
    else:
        found = [k for k, name in enumerate(names) if channel in (k, name)]
        if not found:
            raise _refuse("missing", f"channel has to be one of {', '.join(names)}")
        chosen = channels[found[0]]
    given: dict[str, Any] = {}
    if chosen.physical_sizes is None:
        if spacing is None:
            raise _refuse("missing", f"{path.name} says no distance of its heights: spacing=…")
        counts = chosen.nb_grid_pts
        steps = [
            one / length_in_mm(unit or "mm")
            for one in _pair(spacing, "spacing", length_in_mm(unit or "mm"))
        ]
        given["physical_sizes"] = tuple(a * b for a, b in zip(counts, steps, strict=True))
    if chosen.unit is None:
        if unit is None:
            raise _refuse("missing", f'{path.name} says no unit: unit="µm", say')
        given["unit"] = unit
    notes = [f"{reader.format()} by SurfaceTopography"]
    if len(names) > 1:
        notes.append(f"channel {chosen.name} of {', '.join(names)}")
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        topography = chosen.topography(**given)
    notes += [
        str(one.message).split("\n")[0] for one in told if issubclass(one.category, UserWarning)
    ]
    raw = _of_topography(topography, None, None)
    raw.notes = notes
    _ask_for_scale(raw, path.name)
    return raw


def _ask_for_scale(raw: _Raw, name: str) -> None:
    """Refuses distances and slopes of a file that no measured surface has: another unit."""
    if raw.spacing is None or not raw.across:
        return
    step = [float(one) * length_in_mm(raw.across) for one in raw.spacing]
    heights = grid_of(raw.heights) * length_in_mm(raw.across)
    steep = np.concatenate([(np.diff(heights, axis=axis) / step[axis]).ravel() for axis in (0, 1)])
    known = steep[np.isfinite(steep)]
    slope = float(np.sqrt(np.mean(known**2))) if len(known) else 0.0
    if max(step) <= _LARGEST_STEP and (slope == 0.0 or _SLOPES[0] <= slope <= _SLOPES[1]):
        return
    raise _refuse(
        "implausible",
        f"{name} has a height every {max(step):.4g} mm and a mean slope of {slope:.2g} as it is "
        f"read, which no surface has: a unit is wrong. {_SCALED}",
    )


def _of_topography(topography: Any, spacing: Pair | None, unit: str | None) -> _Raw:
    """A topography of SurfaceTopography: heights and sizes have one unit."""
    if topography.dim != 2:
        raise _refuse("invalid", "a line scan is no surface: brinell.trace reads it")
    said = topography.unit
    if said and unit and length_in_mm(said) != length_in_mm(unit):
        raise _refuse("inconsistent", f"unit={unit!r}, and the topography says {said!r}")
    own = topography.pixel_size if topography.physical_sizes is not None else None
    return _Raw(
        topography.heights(), own if own is not None else spacing, said or unit, said or unit, []
    )


def _of_table(table: Any, spacing: Pair | None, unit: str | None, height_unit: str | None) -> _Raw:
    """A table of pandas: labels of lines and columns that are figures are places x and y."""
    notes: list[str] = []
    up = height_unit or unit or "mm"
    names = [str(one).strip().lower() for one in table.columns]
    if sorted(names) == ["x", "y", "z"]:
        ordered = table.iloc[:, [names.index(one) for one in "xyz"]]
        return _Raw(ordered, spacing, unit or "mm", up, notes)
    steps: list[float | None] = [None, None]
    for axis, (what, labels) in enumerate((("index", table.index), ("columns", table.columns))):
        try:
            place = np.asarray(labels, dtype=float)
        except (TypeError, ValueError):
            continue
        found = np.diff(place)
        if not len(found) or (found == 1).all():
            continue
        if np.ptp(found) > 1e-3 * abs(found.mean()) or found[0] == 0:
            raise _refuse(
                "invalid", f"the labels of the {what} of the table do not rise by equal steps"
            )
        if found[0] < 0:
            table = table.iloc[::-1] if axis == 0 else table.iloc[:, ::-1]
            notes.append(f"the labels of the {what} fall: turned round")
        steps[axis] = None if (found == -1).all() else abs(float(found.mean()))
    given = _pair(spacing, "spacing") if spacing is not None else None
    for k, (what, step) in enumerate(zip(("index", "columns"), steps, strict=True)):
        if step is None or given is None:
            continue
        if isinstance(spacing, Quantity) or abs(given[k] - step) > 1e-3 * step:
            raise _refuse(
                "inconsistent",
                f"spacing is given, and the {what} of the table has steps of {step:g}",
            )
    own = (steps[0], steps[1]) if None not in steps else None
    return _Raw(table, own if own is not None else spacing, unit or "mm", up, notes)


def _of_xarray(
    array: Any, spacing: Pair | None, unit: str | None, height_unit: str | None
) -> _Raw:
    """An array of xarray: its coordinates are places, its attributes `units` units."""
    notes: list[str] = []
    if array.ndim != 2:
        raise _refuse("invalid", f"heights have two dimensions, not {tuple(array.dims)}")
    packed = [one for one in ("scale_factor", "add_offset", "_FillValue") if one in array.attrs]
    if packed:
        raise _refuse(
            "invalid",
            f"the array is packed ({', '.join(packed)}): open it with mask_and_scale=True",
        )
    order = [str(one).lower() for one in array.dims]
    if order[0] in ("y", "lat", "row") or order[1] == "x":
        array = array.T
        notes.append(f"x is {array.dims[0]}, y is {array.dims[1]}")
    steps, units = [], []
    for axis in array.dims:
        if axis not in array.coords:
            continue
        place = np.asarray(array.coords[axis], dtype=float)
        found = np.diff(place)
        if not len(found) or np.ptp(found) > 1e-3 * abs(found.mean()) or found[0] == 0:
            raise _refuse("invalid", f"{axis} does not rise by equal steps")
        if found[0] < 0:
            array = array.isel({axis: slice(None, None, -1)})
            notes.append(f"{axis} falls: turned round")
        steps.append(abs(float(found.mean())))
        units.append(array.coords[axis].attrs.get("units"))
    own = steps if len(steps) == 2 else None
    if own and spacing is not None:
        raise _refuse("inconsistent", "spacing is given, and the coordinates say it")
    across = next((one for one in units if one), None) if own else None
    if across and any(one and one != across for one in units):
        raise _refuse("inconsistent", f"the coordinates are in {' and in '.join(units)}")
    up = array.attrs.get("units")
    if str(array.attrs.get("positive", "up")).lower() == "down":
        raise _refuse("inconsistent", "its heights count downward (positive = down): give -array")
    for name, said, given in (("unit", across, unit), ("height_unit", up, height_unit)):
        if said and given and length_in_mm(said) != length_in_mm(given):
            raise _refuse("inconsistent", f"{name}={given!r}, and the array says {said!r}")
    return _Raw(array.values, own or spacing, across or unit, up or height_unit or unit, notes)


def _without_no_data(
    heights: Floats, no_data: float | Iterable[float] | None, unit: str
) -> tuple[Floats, list[str]]:
    """The same with holes where figures stand for no height, and notes.

    Raises `InvalidJob` for figures that look like such and are not said to be heights.
    """
    if no_data is None:
        return heights, []
    is_one = isinstance(no_data, str) or not isinstance(no_data, Iterable)
    several: list[Any] = [no_data] if is_one else [*no_data]  # type: ignore[misc]
    told = [float(one) for one in several]
    notes = []
    holes = np.zeros(heights.shape, dtype=bool)
    for figure in told:
        holes |= np.isclose(heights, figure, rtol=1e-6, atol=0)
    if holes.any():
        notes.append(f"{grouped(int(holes.sum()))} heights of {_listed(told)} are holes")
        heights = np.where(holes, np.nan, heights)
    elif told and not np.isnan(told).any():
        notes.append(f"no height is {_listed(told)}")
    suspects = _no_heights(heights, unit)
    if suspects:
        raise InvalidJob(
            [Fault(f"#/surface/heights/{i}/{j}", "no_data", words) for (i, j), words in suspects],
            "not taken as a surface",
        )
    for words in _islands(heights, unit):
        warnings.warn(words, stacklevel=4)
        notes.append(words)
    return heights, notes


def _listed(figures: Iterable[float]) -> str:
    return ", ".join(f"{one:g}" for one in figures)


def _no_heights(heights: Floats, unit: str) -> list[tuple[tuple[int, int], str]]:
    """Figures far from all others, with the first place of each group and what is wrong."""
    found: list[tuple[tuple[int, int], str]] = []
    left = heights[np.isfinite(heights)]
    while len(left) > 1:
        low, high = float(left.min()), float(left.max())
        groups = []
        for far in {low, high}:
            rest = left[left != far]
            if not len(rest):
                continue
            reach = float(np.ptp(rest))
            gap = float(np.abs(rest - far).min())
            known = far in _KNOWN and gap > reach / 2
            if known or (reach > 0 and gap > _FAR * reach):
                groups.append(far)
        middle, spread = float(np.median(left)), float(np.ptp(np.percentile(left, [20, 80])))
        if groups:
            bad = np.isin(heights, groups)
        elif spread > 0:
            bad = np.abs(heights - middle) > _FAR * spread
        else:
            break
        if not bad.any():
            break
        i, j = np.argwhere(bad)[0]
        figures = np.unique(heights[bad])
        rest = left[~np.isin(left, figures)]
        said = f"{figures[0]:g}" + (f" to {figures[-1]:g}" if len(figures) > 1 else "")
        others = f"; the others reach over {float(np.ptp(rest)):g} {unit}" if len(rest) else ""
        found.append(
            (
                (int(i), int(j)),
                f"{grouped(int(bad.sum()))} of {grouped(heights.size)} heights are {said} {unit}, "
                f"the first at [{i}, {j}]{others}: no data? no_data={figures[0]:g} makes holes of "
                "them, no_data=None takes all as heights",
            )
        )
        heights = np.where(bad, np.nan, heights)
        left = rest
    return found


def _islands(heights: Floats, unit: str) -> list[str]:
    """Blocks of one value in a map that else has none, and ends that stand apart."""
    left = heights[np.isfinite(heights)]
    for end in {float(left.min()), float(left.max())} if len(left) else ():
        rest = left[left != end]
        count = len(left) - len(rest)
        if len(rest) and count >= _SEVERAL and np.abs(rest - end).min() > np.ptp(rest) > 0:
            i, j = np.argwhere(heights == end)[0]
            return [
                f"{grouped(count)} of {grouped(heights.size)} heights are {end:g} {unit}, further "
                f"from all others than these reach, the first at [{i}, {j}]: no data? "
                f"no_data={end:g} makes holes of them"
            ]
    same = np.isfinite(heights[:-1, :-1])
    for other in (heights[1:, :-1], heights[:-1, 1:], heights[1:, 1:]):
        same = same & (heights[:-1, :-1] == other)
    values, counts = np.unique(heights[:-1, :-1][same], return_counts=True)
    if not len(values):
        return []
    value = float(values[counts.argmax()])
    others = int(counts.sum() - counts.max())
    count = int(np.count_nonzero(heights == value))
    if others > 0.1 * counts.max() or count > 0.5 * heights.size or counts.max() < 4:
        return []
    i, j = np.argwhere(same & (heights[:-1, :-1] == value))[0]
    return [
        f"{grouped(count)} of {grouped(heights.size)} heights are {value:g} {unit} in blocks, the "
        f"first at [{i}, {j}]: no data? no_data={value:g} makes holes of them"
    ]


def _harmonic(heights: Floats) -> Floats:
    """Heights with each missing one the mean of its neighbours."""
    sparse, solve = need("scipy.sparse", "surfaces"), need("scipy.sparse.linalg", "surfaces")
    hole = ~np.isfinite(heights)
    if hole.all():
        raise _refuse("missing", "all heights are missing")
    number = np.full(heights.shape, -1)
    number[hole] = np.arange(hole.sum())
    rows: list[Any] = []
    columns: list[Any] = []
    count = np.zeros(int(hole.sum()))
    right = np.zeros(int(hole.sum()))
    here, there = (slice(None, -1), slice(1, None))
    every = slice(None)
    for a, b in (
        ((here, every), (there, every)),
        ((there, every), (here, every)),
        ((every, here), (every, there)),
        ((every, there), (every, here)),
    ):
        mine, other = number[a], number[b]
        inside = mine >= 0
        np.add.at(count, mine[inside], 1.0)
        both = inside & (other >= 0)
        rows.append(mine[both])
        columns.append(other[both])
        rim = inside & (other < 0)
        np.add.at(right, mine[rim], heights[b][rim])
    i, j = np.concatenate(rows), np.concatenate(columns)
    matrix = sparse.diags(count) - sparse.coo_matrix((np.ones(len(i)), (i, j)), (len(count),) * 2)
    filled: Floats = heights.copy()
    filled[hole] = solve.spsolve(matrix.tocsc(), right)
    return filled


def _means(heights: Floats, axis: int, times: float, count: int) -> Floats:
    """Means over `count` cells, each `times` as long as the old, in the middle of an axis."""
    lines = np.moveaxis(heights, axis, 0)
    start = (len(lines) - times * count) / 2
    edges = start + times * np.arange(count + 1)
    known = np.isfinite(lines)

    def up_to(of: Floats) -> Floats:
        sums = np.concatenate([np.zeros((1, of.shape[1])), np.cumsum(of, axis=0)])
        whole = np.clip(np.floor(edges + 1e-9).astype(int), 0, len(of))
        part = np.clip(edges - whole, 0, 1)[:, None]
        following = np.minimum(whole, len(of) - 1)
        total: Floats = sums[whole] + part * of[following] * (whole < len(of))[:, None]
        return total

    middle = np.nanmean(lines)
    total = np.diff(up_to(np.where(known, lines - middle, 0.0)), axis=0)
    weight = np.diff(up_to(known.astype(float)), axis=0)
    with np.errstate(invalid="ignore", divide="ignore"):
        means = np.where(weight > 1e-6, total / weight + middle, np.nan)
    back: Floats = np.moveaxis(means, 0, axis)
    return back


def _micro(length: float) -> str:
    """A length in mm, as people write small ones."""
    size = abs(length)
    if size == 0:
        return "0"
    for name, factor in (("m", 1e3), ("mm", 1.0), ("µm", 1e-3)):
        if size >= factor:
            return f"{length / factor:.4g} {name}"
    return f"{length * 1e6:.4g} nm"


def _words(pair: Iterable[float]) -> str:
    a, b = (_micro(one) for one in pair)
    return a if a == b else f"{a} × {b}"


def _part(before: float, after: float) -> str:
    return f"{100 * max(0.0, 1 - after / before):.0f} %" if before > 0 else "0 %"
