"""A material behind a measured curve of force over approach."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from ._arrays import Floats, floats_of
from ._client import Client
from ._errors import BrinellError, Fault, InvalidJob
from ._plain import JobLike, document_of, is_length_of, need, tokens_of, with_values

if TYPE_CHECKING:
    from matplotlib.axes import Axes

COMPLIANCE = "frame_compliance"
"""Approach of frame and fixture per force, beside that of the bodies [mm/N]."""

# Most loads of one job; a longer curve is taken as means of neighbouring points.
_LOADS = 24
# Relative steps of differences: of the search, and of the slopes that tell deviations. Meshes
# change with the parameters by small leaps, which the shorter step takes for slopes.
_STEP, _WIDE_STEP = 0.02, 0.08
# Increments of each load, whose number would follow the parameters by leaps.
_INCREMENTS = 24
# A parameter is at a bound within this part of its range; a curve is missed by this part of it.
_AT_BOUND, _MISSED = 0.002, 0.2
# Forces within this part of the largest are the noise of a machine without contact.
_NOISE = 0.01
# A direction of the parameters is told by the data if they fix it within this factor.
_TOLD = 0.5


@dataclass(frozen=True, eq=False)
class Identification:
    """Parameters behind a curve, and how well it tells them."""

    values: dict[str, float]
    """The parameters, in mm, N and MPa."""
    deviations: dict[str, float]
    """Their standard deviations, of the residuals alone; infinite where the curve says nothing."""
    correlation: Floats
    """Correlation of the parameters, in their order."""
    covariance: Floats
    """Covariance of the relative parameters: of ln p, and of compliance over its scale."""
    undetermined: list[str]
    """What the curve does not tell, in words: directions of the parameters, parameters that end
    at a bound, a curve that is not met."""
    force: Floats
    """Forces of the compared points [N]."""
    measured: Floats
    """Measured approach at each [mm]."""
    computed: Floats
    """Approach of the bodies and the frame with these parameters [mm]."""
    mesh_error: float
    """Largest relative error that the mesh leaves in an approach; `deviations` lack it."""
    sweeps: int
    """How often jobs were sent side by side."""
    notes: list[str]
    """What was left out of the curve."""
    job: dict[str, Any] = field(repr=False)
    """The job with these parameters."""
    _scales: Floats = field(repr=False)
    _noise_known: bool = field(repr=False)
    _axes: tuple[str, str] = field(repr=False)
    """What was measured, and over what."""

    @property
    def residuals(self) -> Floats:
        """Computed minus measured approach [mm]."""
        return self.computed - self.measured

    def covers(self, values: Mapping[str, float], level: float = 0.95) -> bool:
        """Whether parameters lie within the joint region of this confidence."""
        stats = need("scipy.stats", "identify")
        off = np.array(
            [
                (values[name] - one) / scale
                if name == COMPLIANCE
                else math.log(values[name] / one)
                for (name, one), scale in zip(self.values.items(), self._scales, strict=True)
            ]
        )
        count, free = len(off), len(self.measured) - len(off)
        distance = float(off @ np.linalg.pinv(self.covariance) @ off)
        if self._noise_known:
            return bool(distance <= stats.chi2.ppf(level, count))
        return bool(distance <= count * stats.f.ppf(level, count, free))

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws the measured and the computed curve."""
        if ax is None:
            ax = need("matplotlib.pyplot", "plot").subplots(layout="constrained")[1]
        assert ax is not None
        ax.plot(1e3 * self.measured, self.force, "o", label="measured")
        said = "\n".join(f"{name} {value:.4g}" for name, value in self.values.items())
        ax.plot(1e3 * self.computed, self.force, label=said)
        ax.set(xlabel=f"{self._axes[0]} [µm]", ylabel=self._axes[1])
        ax.legend(frameon=False)
        return ax

    def plot_residuals(self, ax: Axes | None = None) -> Axes:
        """Draws how far the computed curve is off."""
        if ax is None:
            ax = need("matplotlib.pyplot", "plot").subplots(layout="constrained")[1]
        assert ax is not None
        ax.axhline(0, color="0.7")
        ax.plot(self.force, 1e3 * self.residuals, "o-")
        ax.set(xlabel=self._axes[1], ylabel=f"computed − measured {self._axes[0]} [µm]")
        return ax

    def __str__(self) -> str:
        lines = [
            f"{name} {value:.5g} ± {self.deviations[name]:.2g}"
            for name, value in self.values.items()
        ]
        if self.mesh_error > 0:
            lines.append(
                f"the mesh leaves {100 * self.mesh_error:.1f} % of the {self._axes[0]} "
                "open, which these deviations lack"
            )
        return "\n".join([*lines, *self.undetermined, *self.notes])


def identify(
    curve: Any,
    job: JobLike,
    free: Sequence[str],
    *,
    client: Client | None = None,
    bounds: Mapping[str, tuple[float, float]] | None = None,
    scatter: Literal["absolute", "relative"] = "absolute",
    noise: float | None = None,
    measured: Literal["approach", "diameter", "dent"] = "approach",
) -> Identification:
    """Finds parameters of a job whose approach under the forces of a curve is that of the curve.

    The job starts from the values that stand in it. Forces that fall are a history of flow
    theory.

    Args:
        curve: two columns, approach [mm] and force [N; N/mm in plane analyses]: an array or a
            table, in the order of the test.
        job: the job, with any load; its own is replaced.
        free: pointers, or names of figures of hardening laws such as "yield_stress" and
            "exponent", which are set in each body that has them. "frame_compliance" [mm/N] is
            that of the machine.
        client: where the jobs are solved; a local server if left out.
        bounds: least and largest value by name; a tenth and ten times the start if left out.
        scatter: whether the approach scatters by a length that is the same at every point, or in
            proportion to itself.
        noise: standard deviation of this scatter (a length [mm], or a part), if it is known;
            otherwise it follows from the residuals. As many points as parameters need it.
        measured: the first column of `curve`: the approach under a force; the diameter [mm] that
            the test of the job, `load.hardness` with a ball, leaves under a force; or the height
            [mm] of the lower body over its undeformed surface at a radius or place x [mm], the
            second column, after the last load of the job.

    Raises:
        InvalidJob: the curve has holes or too few points, or a name is not in the job.
    """
    optimize = need("scipy.optimize", "identify")
    document = document_of(job)
    for name, word, words in (
        ("measured", measured, _SEEN),
        ("scatter", scatter, ("absolute", "relative")),
    ):
        if word not in words:
            raise _fault(name, f"is one of {', '.join(words)}, not {word!r}")
    if noise is not None and not 0 < noise < math.inf:
        raise _fault("noise", f"is a standard deviation above 0, not {noise!r}")
    approach, force, notes = _points(curve, measured)
    _plausible(document, approach, measured)
    if isinstance(free, str) or len(free) != len(set(free)) or not free:
        raise _fault("free", "has to name parameters, each once")
    if unknown := set(bounds or {}) - set(free):
        raise _fault("bounds", f"have {', '.join(sorted(unknown))}, which is not in free")
    places = {name: _places(document, name) for name in free if name != COMPLIANCE}
    if len(force) < len(free) + (noise is None):
        raise _fault("curve", f"{len(force)} points tell no {len(free)} parameters")
    if measured != "approach" and COMPLIANCE in free:
        raise _fault("free", f"has {COMPLIANCE}, which only an approach has")
    trials = _TRIALS[measured](document, force)
    for trial in trials:
        solver = trial.get("solver") or {}
        if solver.get("theory", "flow") == "flow" and solver.get("method") not in (
            "jiang_shang",
            "paper",
        ):
            trial["solver"] = {"increments": _INCREMENTS, **solver}
    compliance_scale = float(np.ptp(approach) / np.ptp(force))
    starts = {name: _start(document, name, where) for name, where in places.items()}
    limits = {name: (0.1 * one, 10 * one) for name, one in starts.items()}
    limits = {COMPLIANCE: (0.0, compliance_scale), **limits, **(bounds or {})}
    for name in free:
        if not _is_range(limits[name], 0 if name == COMPLIANCE else math.ulp(0.0)):
            raise _fault("bounds", f"of {name} are two numbers above 0, the larger one last")

    def values_at(point: Floats) -> dict[str, float]:
        return {
            name: float(compliance_scale * one)
            if name == COMPLIANCE
            else starts[name] * math.exp(one)
            for name, one in zip(free, point, strict=True)
        }

    def values_in(point: Floats) -> dict[str, float]:
        found = values_at(point)
        return {pointer: found[name] for name, where in places.items() for pointer in where}

    def scaled(name: str, value: float) -> float:
        return value / compliance_scale if name == COMPLIANCE else math.log(value / starts[name])

    low, high = ([scaled(name, limits[name][side]) for name in free] for side in (0, 1))
    for name, a, b in zip(free, low, high, strict=True):
        if name != COMPLIANCE and not a <= 0 <= b:
            raise _fault("bounds", f"of {name} have to contain its start")
    # The compliance enters in proportion; it needs no job of its own.
    solved = [k for k, name in enumerate(free) if name != COMPLIANCE]
    stiff = free.index(COMPLIANCE) if COMPLIANCE in free else None
    scale = approach if scatter == "relative" else np.full(len(approach), np.ptp(approach))
    search_step = _STEP if measured == "approach" else _WIDE_STEP
    if not (scale > 0).all():
        raise _fault("curve", 'has an approach of 0, which has no scatter="relative"')
    sweeps, mesh_error = 0, 0.0
    own = client is None
    service = client or Client()

    def approaches(points: Iterable[Floats]) -> list[Floats]:
        nonlocal sweeps, mesh_error
        sweeps += 1
        mesh_error = 0.0
        found = []
        each = len(trials)
        jobs = [with_values(trial, values_in(point)) for point in points for trial in trials]
        results = [result for _, result in service.map(jobs, ordered=True)]
        for result in results:
            if result.error is not None:
                raise result.error
            if not result.converged:
                raise BrinellError(
                    f"a trial is {result.status}: bounds=... keep the search where jobs converge"
                )
        for first in range(0, len(results), each):
            values, error = _SEEN[measured](results[first : first + each], force)
            found.append(values)
            mesh_error = max(mesh_error, error)
        return found

    def with_frame(bodies: Floats, point: Floats) -> Floats:
        return bodies if stiff is None else bodies + point[stiff] * compliance_scale * force

    cache: dict[bytes, tuple[Floats, Floats]] = {}

    def evaluated(point: Floats, step: float = search_step) -> tuple[Floats, Floats]:
        """Residuals and their derivatives, whose jobs are solved side by side."""
        key = point.tobytes()
        if key not in cache or step != search_step:
            moves = [step * row for row in np.eye(len(point))[solved]]
            steps = [point, *(p for move in moves for p in (point + move, point - move))]
            middle, *around = approaches(steps)
            slopes = np.zeros((len(force), len(point)))
            for at, k in enumerate(solved):
                slopes[:, k] = (around[2 * at] - around[2 * at + 1]) / (2 * step)
            if stiff is not None:
                slopes[:, stiff] = compliance_scale * force
            cache[key] = ((with_frame(middle, point) - approach) / scale, slopes / scale[:, None])
        return cache[key]

    start = np.array([0.0 if n != COMPLIANCE else 0.05 for n in free])
    inside = np.clip(start, np.array(low) + 1e-6, np.array(high) - 1e-6)
    try:
        optimize.least_squares(
            lambda point: evaluated(point)[0],
            inside,
            jac=lambda point: evaluated(point)[1],
            bounds=(low, high),
            x_scale=[1.0 if n != COMPLIANCE else 0.1 for n in free],
            xtol=1e-5,
            ftol=1e-8,
            max_nfev=12 if len(free) <= 2 else 26,
        )
        # Meshes change with the parameters by small leaps: the best point need not be the last.
        best = np.frombuffer(min(cache, key=lambda key: float(cache[key][0] @ cache[key][0])))
        residuals, slopes = evaluated(best, _WIDE_STEP)
    finally:
        if own:
            service.close()
    variance = (
        (noise if scatter == "relative" else noise / float(scale[0])) ** 2
        if noise is not None
        else float(residuals @ residuals) / (len(force) - len(free))
    )
    covariance = np.linalg.pinv(slopes.T @ slopes, rcond=1e-14) * variance
    relative = np.sqrt(np.diag(covariance))
    found = values_at(best)
    blind = _blind(slopes, max(math.sqrt(variance), 1e-6), free)
    for name, one, a, b in zip(free, best, low, high, strict=True):
        if min(one - a, b - one) < _AT_BOUND * (b - a) and name != COMPLIANCE:
            blind.append(f"{name} ends at its bound, {limits[name][int(b - one < one - a)]:.5g}")
    if (worst := float(np.abs(residuals).max())) > _MISSED:
        blind.append(
            f"the curve is not met: {100 * worst:.0f} % of its "
            f"{'value' if scatter == 'relative' else 'range'} are missed at one point"
        )
    steps = {name: compliance_scale if name == COMPLIANCE else found[name] for name in free}
    with np.errstate(invalid="ignore", divide="ignore"):
        correlation = covariance / np.outer(relative, relative)
    return Identification(
        values=found,
        deviations={name: float(r * steps[name]) for name, r in zip(free, relative, strict=True)},
        correlation=correlation,
        covariance=covariance,
        undetermined=blind,
        force=force,
        measured=approach,
        computed=approach + scale * residuals,
        mesh_error=mesh_error,
        sweeps=sweeps,
        notes=notes,
        job=with_values(trials[0], values_in(best)),
        _scales=np.array([steps[name] for name in free]),
        _noise_known=noise is not None,
        _axes=_AXES[measured],
    )


def _fault(where: str, detail: str) -> InvalidJob:
    return InvalidJob([Fault(f"#/{where}", "invalid", f"{where} {detail}")], "nothing to identify")


def _points(curve: Any, measured: str) -> tuple[Floats, Floats, list[str]]:
    """Both columns; approach and force as means of neighbours where the curve is long."""
    table = floats_of(curve, "#/curve")
    if table.ndim == 2 and table.shape[0] == 2 and table.shape[1] > 2:
        table = table.T
    if table.ndim != 2 or table.shape[1] != 2:
        raise _fault("curve", f"has two columns, approach and force, not {table.shape}")
    holes = np.argwhere(~np.isfinite(table))
    if len(holes):
        raise _fault("curve", f"has {len(holes)} holes, the first at {holes[0].tolist()}")
    if measured == "dent":
        return table[:, 0], table[:, 1], []
    table, notes = _in_contact(table)
    if (table[:, 1] < 0).any() or not np.ptp(table[:, 1]) > 0:
        raise _fault("curve", "needs forces of at least 0 that differ")
    if measured == "approach" and len(table) > _LOADS:
        table = np.array([part.mean(axis=0) for part in np.array_split(table, _LOADS)])
    return table[:, 0], table[:, 1], notes


def _in_contact(table: Floats) -> tuple[Floats, list[str]]:
    """The curve from its contact on: what stands before has no force, or one within the noise of
    the machine.
    """
    force = table[:, 1]
    noise = _NOISE * float(force.max(initial=0.0))
    none = np.flatnonzero(force[: int(np.argmax(force > noise))] <= 0)
    before = int(none[-1]) + 1 if len(none) else 0
    below = force[:before][force[:before] < 0]
    if not len(below):
        return table[before:], []
    if below.min() < -noise:
        return table, []
    note = (
        f"{before} points before the contact are cut, {len(below)} of them with forces below 0, "
        f"down to {float(below.min()):.3g} N"
    )
    return table[before:], [note]


def _plausible(document: Mapping[str, Any], column: Floats, measured: str) -> None:
    """Refuses a first column that no such bodies have: columns in another order, other units."""
    if measured == "dent":
        return
    if not (column > 0).all():
        raise _fault("curve", f"has {float(column.min()):.4g} as {measured}; all are above 0")
    size = _ball(document) if measured == "diameter" else _depth(document)
    if size is not None and column.max() > size:
        raise _fault(
            "curve",
            f"has {float(column.max()):.4g} mm as {measured}, more than the {size:.4g} mm of the "
            f"{'ball' if measured == 'diameter' else 'bodies'}: its columns are {measured} [mm], "
            "force [N], in this order",
        )


def _ball(document: Mapping[str, Any]) -> float | None:
    test = (document.get("load") or {}).get("hardness")
    ball = test.get("ball") if isinstance(test, Mapping) else None
    return float(ball) if isinstance(ball, (int, float)) else None


def _depth(document: Mapping[str, Any]) -> float | None:
    """Largest length of the shapes of both bodies, in mm."""
    shapes = [(document.get(body) or {}).get("shape") or {} for body in ("upper", "lower")]
    lengths = [
        value
        for shape in shapes
        for name, value in shape.items()
        if is_length_of(name) and isinstance(value, (int, float))
    ]
    scale = 1000.0 if document.get("units") == "SI" else 1.0
    return scale * max(lengths) if lengths else None


def _is_range(given: Any, least: float) -> bool:
    try:
        low, high = (float(one) for one in given)
    except (TypeError, ValueError):
        return False
    return least <= low < high < math.inf


def _under_forces(document: dict[str, Any], force: Floats) -> list[dict[str, Any]]:
    trial = {**document, "load": _load(force)}
    if "history" in trial["load"]:
        trial["solver"] = {**trial.get("solver", {}), "theory": "flow"}
    return [trial]


def _as_it_is(document: dict[str, Any], _: Floats) -> list[dict[str, Any]]:
    return [document]


def _tests(document: dict[str, Any], force: Floats) -> list[dict[str, Any]]:
    """The test of a job, as a ball under each force."""
    test = (document.get("load") or {}).get("hardness")
    if not isinstance(test, dict) or not isinstance(test.get("ball"), (int, float)):
        raise _fault("job", 'needs {"hardness": {"scale": ..., "ball": ...}} as its load')
    ball = {k: v for k, v in test.items() if k not in ("force", "force_kgf")}
    return [
        {**document, "load": {"hardness": {**ball, "scale": "sphere", "force": float(one)}}}
        for one in force
    ]


def _approaches(results: Sequence[Any], force: Floats) -> tuple[Floats, float]:
    (result,) = results
    if len(result.steps) != len(force):
        raise BrinellError("a trial has not all loads")
    return np.array([step.approach for step in result.steps]), _most(result.steps, "approach")


def _diameters(results: Sequence[Any], force: Floats) -> tuple[Floats, float]:
    return np.array([result["diameter"] for result in results]), _most(results, "diameter")


def _heights(results: Sequence[Any], place: Floats) -> tuple[Floats, float]:
    (result,) = results
    step = result.steps[-1]
    surface = (step.data.get("surfaces") or {}).get("lower")
    if not surface:
        raise BrinellError('a dent needs theory="flow" and a lower body that yields')
    heights = np.interp(place, surface["x"], surface["height"])
    return heights, _most([step], "dent_depth")


def _most(figures: Sequence[Any], name: str) -> float:
    """The largest error of a figure that is bounded."""
    errors: list[float] = [row.error for one in figures for row in one.answers if row.name == name]
    return max([0.0, *(error for error in errors if math.isfinite(error))])


_TRIALS = {"approach": _under_forces, "diameter": _tests, "dent": _as_it_is}
_SEEN = {"approach": _approaches, "diameter": _diameters, "dent": _heights}
_AXES = {
    "approach": ("approach", "force [N]"),
    "diameter": ("diameter", "force [N]"),
    "dent": ("height", "place [mm]"),
}


def _load(force: Floats) -> dict[str, Any]:
    if (np.diff(force) > 0).all():
        return {"forces": force.tolist()}
    return {"history": [{"force": float(one)} for one in force]}


def _places(document: Mapping[str, Any], name: str) -> list[str]:
    """Pointers of a parameter in a job."""
    if name.startswith(("/", "#")):
        where = [name.removeprefix("#")]
    else:
        where = [
            f"/{body}/material/plasticity/{name}"
            for body in ("upper", "lower")
            if name in ((document.get(body) or {}).get("material", {}).get("plasticity") or {})
        ]
    if not where:
        laws = [
            key
            for body in ("upper", "lower")
            for key, value in (
                ((document.get(body) or {}).get("material", {}).get("plasticity") or {}).items()
            )
            if isinstance(value, (int, float))
        ]
        known = ", ".join(dict.fromkeys([*laws, COMPLIANCE]))
        raise _fault("free", f"has {name!r}, which is not in the job: {known}")
    return where


def _start(document: Mapping[str, Any], name: str, where: list[str]) -> float:
    place: Any = document
    for step in tokens_of(where[0]):
        try:
            place = place[int(step)] if isinstance(place, list) else place[step]
        except (KeyError, IndexError, TypeError, ValueError):
            raise _fault("free", f"has {name!r}, which is not in the job") from None
    if not isinstance(place, (int, float)) or not place > 0:
        raise _fault("free", f"has {name!r}, which starts from {place!r} and not above 0")
    return float(place)


def _blind(slopes: Floats, noise: float, free: Sequence[str]) -> list[str]:
    """Directions in which the parameters may change by half without being seen."""
    _, sizes, rows = np.linalg.svd(slopes, full_matrices=False)
    found = []
    for size, row in zip(sizes, rows, strict=True):
        if size > 0 and noise / size <= _TOLD:
            continue
        largest = float(np.abs(row).max())
        parts = [
            f"{name} ({'+' if one > 0 else '−'}{abs(one / largest):.2f})"
            for name, one in zip(free, row, strict=True)
            if abs(one) > 0.1 * largest
        ]
        found.append(f"the curve does not tell {' with '.join(parts)}")
    return found
