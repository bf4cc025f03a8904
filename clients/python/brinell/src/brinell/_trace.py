"""Traces of a stylus: levelled, filtered, thinned to what a profile takes, with what is lost."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal

import numpy as np

from ._arrays import Floats, floats_of, without_mask
from ._errors import Fault, InvalidJob
from ._lengths import is_length, length_in_mm
from ._plain import Quantity, grouped
from ._surface import _micro, _part, _text_of, _without_no_data

MOST = 10_000
"""Most points of a profile."""

# sqrt(ln 2 / pi): the Gaussian of ISO 16610-21 lets half of a wave of the cut-off pass.
_ALPHA = math.sqrt(math.log(2) / math.pi)
# Steps of a filtered trace that lie within its cut-off.
_STEPS = 8
# A step over the median of all beyond which nothing is measured between two points, and the least
# number of points by which that is told.
_GAP, _MANY = 20, 50


@dataclass(frozen=True, eq=False)
class Trace:
    """Points of a measured profile in mm, for `brinell.profile(points=trace, ...)`."""

    x: Floats
    """Places along the trace, rising; 0 at its highest point [mm]."""
    heights: Floats
    """Heights outward, 0 at the highest point [mm]."""
    notes: tuple[str, ...] = ()
    """What was read, changed and lost."""

    @property
    def points(self) -> Floats:
        """`[[x, height], ...]` in mm."""
        return np.column_stack([self.x, self.heights])

    @property
    def rms_height(self) -> float:
        """Pq: root mean square of the heights above their mean line [mm]."""
        return float(np.sqrt(np.mean(_level(self.x, self.heights) ** 2)))

    def in_job(self, unit: str) -> list[list[float]]:
        """The points as a job takes them, lengths in this unit."""
        points: list[list[float]] = (self.points / length_in_mm(unit)).tolist()
        return points

    def filtered(self, cutoff: float) -> Trace:
        """Its long waves: the mean line by the Gaussian filter of ISO 16610-21.

        Half of a wave as long as `cutoff` (λ_c, in mm) passes; what is shorter is roughness, and
        is taken away. Within half a cut-off of the ends, the weights are those of what is there.
        """
        x, z = _even(self.x, self.heights)
        step = float(x[1] - x[0])
        length = float(x[-1] - x[0])
        if not 2 * step <= cutoff <= length:
            raise _refuse(
                "invalid",
                f"cutoff has to be between {_micro(2 * step)}, two steps of the trace, and its "
                f"length {_micro(length)}, not {_micro(cutoff)}",
            )
        reach = math.ceil(cutoff / step)
        at = np.arange(-reach, reach + 1) * step
        weights = np.exp(-math.pi * (at / (_ALPHA * cutoff)) ** 2)
        # Around the straight line, which the filter keeps at the ends too.
        line = z - _level(x, z)
        sums = _convolved(z - line, weights) / _convolved(np.ones_like(z), weights)
        long = sums + line
        every = max(1, int(cutoff / _STEPS / step))
        kept = np.unique(np.append(np.arange(0, len(x), every), len(x) - 1))
        rough = float(np.sqrt(np.mean((z - long) ** 2)))
        note = (
            f"Gaussian filter of ISO 16610-21, cut-off λ_c {_micro(cutoff)}: shorter waves are "
            f"taken away, a roughness Rq of {_micro(rough)} of Pq "
            f"{_micro(self.rms_height)}; the contact has to be several λ_c wide for an answer "
            "without them"
        )
        made = _from_top(x[kept], long[kept])
        return replace(self, x=made[0], heights=made[1], notes=(*self.notes, note))

    def thinned(self, points: int) -> Trace:
        """Every n-th point, `points` of them at most."""
        if points < 2:
            raise _refuse("invalid", "a trace has two points at least")
        if len(self.x) <= points:
            return self
        every = math.ceil((len(self.x) - 1) / (points - 1))
        kept = np.unique(np.append(np.arange(0, len(self.x), every), len(self.x) - 1))
        x, z = self.x[kept], self.heights[kept]
        off = float(np.abs(np.interp(self.x, x, z) - self.heights).max())
        made = replace(self, x=x, heights=z)
        note = (
            f"{grouped(len(self.x))} points thinned to {grouped(len(x))}: up to {_micro(off)} "
            f"away from the trace, {_part(_slope(self), _slope(made))} of its slope Pdq lost"
        )
        x, z = _from_top(x, z)
        return replace(made, x=x, heights=z, notes=(*self.notes, note))

    def __repr__(self) -> str:
        head = (
            f"Trace of {grouped(len(self.x))} points, {_micro(float(np.ptp(self.x)))} long; "
            f"Pq {_micro(self.rms_height)}, Pdq {_slope(self):.3g}"
        )
        return "\n".join([head, *(f"- {note}" for note in self.notes)])


def trace(
    source: Any,
    *,
    spacing: float | Quantity | None = None,
    unit: str | None = None,
    height_unit: str | None = None,
    no_data: float | Iterable[float] | None = (),
    fill: Literal["linear"] | None = None,
    level: bool = True,
    cutoff: float | Quantity | None = None,
    points: int | None = None,
) -> Trace:
    """A measured trace for `brinell.profile(points=trace, depth=...)`.

    The highest point comes to x = 0 and height 0, where the contact begins.

    Args:
        source: two columns x and height (an array of numpy, a table of pandas, the name of a file
            of text), heights alone with a `spacing`, or a line scan of SurfaceTopography.
        spacing: distance of heights, where they come alone: in `unit`, or a quantity.
        unit: unit of x where the source says none; arrays are in mm.
        height_unit: unit of the heights, if it is another.
        no_data: figures that stand for no height, such as -9999. `None`: all are heights.
        fill: "linear" bridges holes; without it, a trace with holes is refused.
        level: takes away the least-squares line.
        cutoff: λ_c [mm]: the Gaussian filter of ISO 16610-21 keeps the longer waves.
        points: thins to this many points.

    Raises:
        InvalidJob: the source lacks a unit or has holes; each fault is named.
    """
    x, z, notes = _read(source, spacing, unit, height_unit, no_data)
    order = np.argsort(x, kind="stable")
    if (np.diff(x) < 0).any():
        notes.append("sorted by x")
    x, z = x[order], z[order]
    known = np.isfinite(z)
    if not np.isfinite(x).all():
        raise _refuse("missing", f"{grouped(int((~np.isfinite(x)).sum()))} points have no place")
    if not known.all():
        count = f"{grouped(int((~known).sum()))} of {grouped(len(z))} heights are missing"
        if fill is None or not known.any():
            first = int(np.argmin(known))
            raise _refuse(
                "missing", f'{count}, the first at point {first + 1}; fill="linear" bridges them'
            )
        z = np.interp(x, x[known], z[known])
        notes.append(f"{count}: bridged")
    single = np.append(True, np.diff(x) > 0)
    if not single.all():
        notes.append(f"{grouped(int((~single).sum()))} further points at the same x left out")
    x, z = x[single], z[single]
    if len(x) < 2:
        raise _refuse("invalid", "a trace has two points at least")
    steps = np.diff(x)
    gap = int(steps.argmax())
    if len(x) > _MANY and steps[gap] > _GAP * float(np.median(steps)):
        notes.append(
            f"nothing is measured over {_micro(float(steps[gap]))} behind point {gap + 1}: a "
            "straight line lies there"
        )
    if level:
        slope = float(np.polyfit(x - x.mean(), z, 1)[0])
        z = _level(x, z)
        notes.append(f"levelled: a slope of {slope:.3g} is taken away")
    x, z = _from_top(x, z)
    made = Trace(x, z, tuple(notes))
    if cutoff is not None:
        made = made.filtered(_length(cutoff))
    if points is not None:
        made = made.thinned(points)
    if len(made.x) > MOST:
        note = (
            f"{grouped(len(made.x))} points: a profile takes {grouped(MOST)}; cutoff=0.8 filters "
            f"them, points={MOST} thins them"
        )
        made = replace(made, notes=(*made.notes, note))
    return made


def _length(value: Any) -> float:
    return float(value.to("mm").magnitude if isinstance(value, Quantity) else value)


def _refuse(kind: str, detail: str) -> InvalidJob:
    return InvalidJob([Fault("#/trace", kind, detail)], "not taken as a trace")


def _read(
    source: Any,
    spacing: Any,
    unit: str | None,
    height_unit: str | None,
    no_data: float | Iterable[float] | None,
) -> tuple[Floats, Floats, list[str]]:
    """Places and heights in mm, and notes."""
    notes: list[str] = []
    if isinstance(source, Trace):
        return source.x, source.heights, list(source.notes)
    if hasattr(source, "positions_and_heights"):
        said = source.unit or unit
        if not said:
            raise _refuse("missing", 'it says no unit: unit="µm", say')
        if source.dim != 1:
            raise _refuse("invalid", "a map is no trace: brinell.surface reads it")
        x, z = (
            np.asarray(without_mask(one), dtype=float) for one in source.positions_and_heights()
        )
        return x * length_in_mm(said), z * length_in_mm(said), notes
    across: str | None = unit or "mm"
    up: str | None = height_unit or across
    if isinstance(source, Quantity):
        source, across, up = source.to("mm").magnitude, "mm", "mm"
    if isinstance(source, (str, os.PathLike)):
        table, units, notes = _table(Path(source))
        for name, said, given in (
            ("unit", units[0], unit),
            ("height_unit", units[1], height_unit),
        ):
            if said and given and length_in_mm(said) != length_in_mm(given):
                raise _refuse("inconsistent", f"{name}={given!r}, and the file says {said!r}")
        across, up = units[0] or unit, units[1] or height_unit or unit
        if table.shape[1] == 1 and isinstance(spacing, Quantity):
            across = "mm"
        lacking = [
            detail
            for name, detail in ((across, 'of x: unit="mm"'), (up, 'of heights: height_unit="µm"'))
            if not name
        ]
        if lacking:
            raise InvalidJob(
                [Fault("#/trace", "missing", f"it says no unit {one}, say") for one in lacking],
                "not taken as a trace",
            )
    else:
        table = floats_of(_of_pandas(source, spacing is not None), "#/trace")
        if table.ndim == 2 and table.shape[0] == 2 and table.shape[1] != 2:
            table = table.T
    assert across
    assert up
    if table.ndim == 1 or table.shape[1] == 1:
        if spacing is None:
            raise _refuse("missing", "heights alone need the distance of them: spacing=0.5, say")
        step = (
            _length(spacing) if isinstance(spacing, Quantity) else spacing * length_in_mm(across)
        )
        if not (step > 0 and math.isfinite(step)):
            raise _refuse("invalid", f"spacing has to be positive, not {spacing}")
        z = table.reshape(-1)
        x = np.asarray(step * np.arange(len(z)), dtype=float)
    elif table.ndim != 2 or table.shape[1] != 2:
        raise _refuse("invalid", f"a trace has two columns, x and height, not {table.shape}")
    else:
        if spacing is not None:
            raise _refuse("inconsistent", "spacing is given, and the first column is x")
        if not _is_in_order(table[:, 0]) and _is_in_order(table[:, 1]):
            raise _refuse(
                "invalid", "the first column, x, does not rise, and the second does: swapped?"
            )
        x, z = table[:, 0] * length_in_mm(across), table[:, 1]
    z, more = _with_holes(z, no_data, up)
    return x, z * length_in_mm(up), notes + more


def _is_in_order(values: Floats) -> bool:
    """Whether values rise or fall throughout."""
    steps = np.diff(values)
    return len(steps) > 1 and bool((steps >= 0).all() or (steps <= 0).all()) and bool(steps.any())


def _of_pandas(source: Any, is_spaced: bool) -> Any:
    """Columns x and height of a table of pandas, by their names or by an index of places."""
    if not hasattr(source, "index") or not hasattr(source, "iloc"):
        return source
    if source.ndim == 2 and source.shape[1] == 2:
        names = [_axis_of(str(one)) for one in source.columns]
        return source.iloc[:, ::-1] if names == [1, 0] else source
    try:
        places = np.asarray(source.index, dtype=float)
    except (TypeError, ValueError):
        return source
    if (np.diff(places) == 1).all() or (source.ndim == 2 and source.shape[1] != 1):
        return source
    if is_spaced:
        raise _refuse("inconsistent", "spacing is given, and the index of the table has places")
    return np.column_stack([places, floats_of(source, "#/trace").reshape(-1)])


def _with_holes(
    z: Floats, no_data: float | Iterable[float] | None, unit: str
) -> tuple[Floats, list[str]]:
    """The same with holes where figures stand for no height, and notes."""
    try:
        column, notes = _without_no_data(z[:, None], no_data, unit)
    except InvalidJob as error:
        found = [
            Fault(
                f"#/trace/{k}",
                fault.code,
                fault.detail.replace(f"[{k}, 0]", f"point {int(k) + 1}"),
            )
            for fault in error.errors
            for k in [fault.pointer.split("/")[-2]]
        ]
        raise InvalidJob(found, "not taken as a trace") from None
    return column[:, 0], notes


_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?|nan|\*+|n/?a", re.IGNORECASE)
# What the columns of a trace are called.
_ALONG = {"x", "weg", "position", "pos", "länge", "length", "distance", "abstand", "abscisse", "s"}
_UPWARD = {"z", "h", "y", "höhe", "height", "profil", "profile", "hauteur", "cote", "amplitude"}


def _axis_of(name: str) -> int | None:
    """0 for the name of a column of places, 1 for one of heights."""
    match = re.match(r"\W*([a-zäöü]+)", name.lower())
    word = match[1] if match else ""
    return 0 if word in _ALONG else 1 if word in _UPWARD else None


def _table(path: Path) -> tuple[Floats, list[str], list[str]]:
    """One or two columns of a file of text, the units of x and of heights, and notes."""
    text = _text_of(path.read_bytes())
    if text is None:
        raise _refuse("not_understood", f"{path.name} is no text")
    lines = re.split(r"\r\n?|\n", text)
    rows: list[list[float]] = []
    head: list[tuple[int, str]] = []
    decimal = any(
        re.search(r"\d,\d", line) and re.search(r"[;\t]|\d\s+[-+\d]", line) for line in lines
    )
    for number, line in enumerate(lines, 1):
        words = [
            one.strip()
            for one in re.split(r"[;\t]|\s+" if decimal else r"[;,\t]|\s+", line.strip())
        ]
        words = [one for one in words if one]
        if not words:
            continue
        figures = [one.replace(",", ".") if decimal else one for one in words]
        if all(_NUMBER.fullmatch(one) for one in figures):
            rows.append(
                [
                    float(one) if one[-1].isdigit() or one[-1] == "." else float("nan")
                    for one in figures
                ]
            )
            if len(rows[-1]) != len(rows[0]) or len(rows[0]) > 2:
                raise _refuse(
                    "not_understood", f"{path.name}: line {number} has {len(words)} columns"
                )
        elif rows:
            raise _refuse(
                "not_understood", f"{path.name}: line {number}: “{line[:40]}” is not a number"
            )
        else:
            head.append((number, line))
    if not rows:
        raise _refuse("not_understood", f"{path.name} has no figures")
    table = np.array(rows)
    units = ["", ""]
    notes: list[str] = []
    for number, line in head:
        said = _said(line, table.shape[1])
        if said is None:
            raise _refuse(
                "not_understood", f"{path.name}: line {number}: “{line[:40]}” is not understood"
            )
        if not said:
            notes.append(f"line {number} (“{line.strip()[:40]}”) left out")
        for axis, name in said:
            if name and units[axis] and units[axis] != name:
                raise _refuse(
                    "inconsistent",
                    f"{path.name}: line {number} says “{name}”, and one above “{units[axis]}”",
                )
            units[axis] = units[axis] or name
        if [axis for axis, _ in said] == [1, 0]:
            table = table[:, ::-1]
            notes.append(f"line {number}: the second column is x")
    return table, units, notes


def _said(line: str, columns: int) -> list[tuple[int, str]] | None:
    """Axes and their units in a line above the figures; `None` if it is not understood.

    A word in brackets that is no unit of length, and a unit of which nothing tells the axis, are
    not understood.
    """
    if re.search(r"\d", line):
        return None
    cells = [one.strip().strip('"') for one in re.split(r"[;\t,]", line) if one.strip()]
    if len(cells) == 1:
        cells = re.findall(r"[^\s\[(/]+\s*[\[(/]\s*[^\s\])]+[\])]?", line) or [line]
    if columns == 2 and len(cells) == 2 and all(map(is_length, cells)):
        return [(0, cells[0]), (1, cells[1])]
    marked = r"[\[(/]\s*([^\])/;,\s]+)|[:=]\s*(\S+)\s*$"
    units = ["".join(found) for one in cells for found in re.findall(marked, one)[-1:]]
    if not units:
        names = [_axis_of(one) for one in cells]
        if len(cells) == 2 and sorted(map(str, names)) == ["0", "1"]:
            return [(int(name or 0), "") for name in names]
        words = [one for one in re.split(r"[\s;,]+", line) if one != "in"]
        return None if any(map(is_length, words)) else []
    if not all(map(is_length, units)):
        return None
    if columns == 1:
        return [(1, units[0])] if len(units) == 1 else None
    if len(cells) == 2 and len(units) == 2:
        swapped = [_axis_of(one) for one in cells] == [1, 0]
        return [(1, units[0]), (0, units[1])] if swapped else [(0, units[0]), (1, units[1])]
    named = [
        (_axis_of(one), "".join((re.findall(marked, one) or [("", "")])[-1])) for one in cells
    ]
    found = [(axis, unit) for axis, unit in named if axis is not None]
    if len(found) == len(cells) and len({axis for axis, _ in found}) == len(found):
        return found
    return None


def _level(x: Floats, z: Floats) -> Floats:
    """Heights above their least-squares line."""
    place = x - x.mean()
    slope = float(place @ z / (place @ place))
    above: Floats = z - z.mean() - slope * place
    return above


def _from_top(x: Floats, z: Floats) -> tuple[Floats, Floats]:
    top = int(np.argmax(z))
    return x - x[top], z - z[top]


def _even(x: Floats, z: Floats) -> tuple[Floats, Floats]:
    """The trace at equal steps, straight between its points."""
    step = float(np.median(np.diff(x)))
    count = round((x[-1] - x[0]) / step) + 1
    even = np.linspace(x[0], x[-1], max(count, 2))
    return even, np.interp(even, x, z)


def _convolved(values: Floats, weights: Floats) -> Floats:
    """A convolution in the place of `values`, by transforms."""
    size = len(values) + len(weights) - 1
    product: Floats = np.fft.irfft(np.fft.rfft(values, size) * np.fft.rfft(weights, size), size)
    start = len(weights) // 2
    return product[start : start + len(values)]


def _slope(of: Trace) -> float:
    """Pdq: root mean square of the slope."""
    return float(np.sqrt(np.mean((np.diff(of.heights) / np.diff(of.x)) ** 2)))
