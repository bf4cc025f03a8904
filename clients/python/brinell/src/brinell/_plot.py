"""Pictures of a result, by matplotlib. Each takes axes to draw into and returns them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._data import ResultData
from ._errors import BrinellError
from ._fields import BodyFields, Fields
from ._html import unit_of_force
from ._plain import need
from ._step import Step

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Of bodies of revolution, where x is the radius.
OF_REVOLUTION = {
    "sigma_x": "radial stress",
    "sigma_y": "axial stress",
    "sigma_z": "hoop stress",
}
TITLES = {
    "von_mises": "von Mises stress",
    "tau_max": "largest shear stress",
    "sigma_x": "tangential stress",
    "sigma_y": "normal stress",
    "sigma_z": "out-of-plane stress",
    "tau_xy": "shear stress",
    "equivalent_plastic_strain": "equivalent plastic strain",
    "yield_stress": "yield stress",
    "utilization": "utilization",
}
# Of a track, where x is the direction of travel.
ROLLED = {"sigma_x": "stress along the travel", "sigma_z": "stress across the travel"}
# Limits over friction: words and line.
LIMITS = {
    "elastic": ("first yield", ":"),
    "perfect": ("shakedown, perfectly plastic", "-"),
    "kinematic": ("shakedown, kinematic hardening", "--"),
}
WITHOUT_UNIT = ("equivalent_plastic_strain", "utilization")
COLOURS = {"upper": "C0", "lower": "C1"}
# How a load is taken away again.
UNLOAD = 'theory="flow" and loads that end with 0, as in history=[{"force": 500}, {"force": 0}]'
# Part of the field's picture that the contact takes, to each side.
CONTACT_PART = 0.3


class Plot:
    """Pictures of a result.

    Steps are counted from 0 as in `result.steps`; the last one is shown unless said.
    """

    def __init__(self, result: ResultData) -> None:
        self._result = result
        si = result.units == "SI"
        self._length, self._stress = ("m", "Pa") if si else ("mm", "MPa")
        round_bodies = result.analysis == "axisymmetric"
        self._along = "r" if round_bodies else "x"
        self._titles = {**TITLES, **(OF_REVOLUTION if round_bodies else {})}

    @property
    def _widest(self) -> float:
        """The largest half-width of all steps; 0 without one."""
        widths = np.array([step.half_width for step in self._result.steps])
        return float(np.nanmax(widths, initial=0.0))

    def pressure(
        self, step: int = -1, ax: Axes | None = None, label: str = "this contact"
    ) -> Axes:
        """Contact pressure, beside Hertz's where there is one."""
        ax = _axes(ax)
        one = self._result.steps[step]
        contact = one.pressure
        touching = np.abs(contact.x[contact.pressure > 0.0])
        rows = {row.name: row.elastic for row in one.answers}
        a, p = (rows.get(name, np.nan) for name in ("half_width", "peak_pressure"))
        a = rows.get("semi_axis_a", a)
        ends = [one for one in (*touching, one.half_width, a, 0.0) if np.isfinite(one)]
        reach = 1.3 * float(max(ends)) if max(ends) > 0.0 else float(np.max(np.abs(contact.x)))
        ax.plot(contact.x, contact.pressure, label=label)
        if a > 0.0 and p > 0.0:
            x = a * np.sin(np.linspace(-np.pi / 2, np.pi / 2, 201))
            ax.plot(
                x, p * np.sqrt(np.maximum(0.0, 1.0 - (x / a) ** 2)), "k:", label="Hertz, elastic"
            )
            ax.legend(frameon=False)
        left, along = (0.0, "radius") if self._result.analysis == "axisymmetric" else (-reach, "x")
        ax.set(xlim=(left, reach), xlabel=f"{along} [{self._length}]")
        ax.set_ylabel(f"pressure [{self._stress}]")
        ax.set_ylim(bottom=0.0)
        return ax

    def depth(
        self,
        quantity: str = "von_mises",
        step: int = -1,
        body: str | None = None,
        ax: Axes | None = None,
        label: str = "",
    ) -> Axes:
        """A stress over the depth below the middle of the contact.

        Von Mises stress beside the yield stress where that varies. With a `label`, which tells
        several results on the same axes apart, every line has a colour of its own.
        """
        ax = _axes(ax)
        one = self._result.steps[step]
        bodies = {
            k: v for k, v in (one.data.get("subsurface") or {}).items() if v and body in (None, k)
        }
        if not bodies:
            raise BrinellError("this step has no stresses over depth")
        known = dict.fromkeys(
            name for values in bodies.values() for name in values if name != "position"
        )
        bodies = {name: values for name, values in bodies.items() if quantity in values}
        if not bodies:
            raise BrinellError(f"no {quantity!r} over depth; there are {', '.join(known)}")
        # Where both bodies are alike one line hides the other, so that the second is dashed.
        before = f"{label}, " if label else ""
        for (name, values), line in zip(bodies.items(), ("-", "--"), strict=False):
            style: dict[str, Any] = {} if label else {"color": COLOURS[name]}
            words = f"{before}{name} body"
            (drawn,) = ax.plot(values["depth"], values[quantity], line, label=words, **style)
            if quantity == "von_mises" and "yield_stress" in values:
                ax.plot(
                    values["depth"],
                    values["yield_stress"],
                    ":",
                    color=drawn.get_color(),
                    label=f"{before}{name}: yield stress",
                )
        if one.half_width > 0.0:
            ax.set_xlim(0.0, 5.0 * one.half_width)
        unit = "" if quantity in WITHOUT_UNIT else f" [{self._stress}]"
        title = self._titles.get(quantity, quantity) + unit
        ax.set(xlabel=self._depth_at(values), ylabel=title)
        ax.legend(frameon=False)
        return ax

    def _depth_at(self, profile: dict[str, Any]) -> str:
        """The axis of depths, and where it lies."""
        place = profile["position"][0]
        return f"depth [{self._length}] at {self._along} = {place:.3g} {self._length}"

    def residual_stress(self, step: int = -1, body: str = "lower", ax: Axes | None = None) -> Axes:
        """Stresses along the surface over depth, as they are left when the load is zero or has
        rolled by; dotted those before it.

        The line runs below the middle of the contact; the axis of depths says where that is.
        """
        ax = _axes(ax)
        one = self._result.steps[step]
        values = (one.data.get("subsurface") or {}).get(body)
        if not values:
            raise BrinellError(f"this step has no stresses over depth in the {body} body")
        rolls = "passes" in one.data
        if not (rolls or (one.unloaded and "surfaces" in one.data)):
            raise BrinellError(f"this step is under load, or does not know unloading: {UNLOAD}")
        for name in ("sigma_x", "sigma_z"):
            title = ROLLED[name] if rolls else self._titles[name]
            (line,) = ax.plot(values["depth"], values[name], label=title)
            before = values.get(f"initial_{name}")
            if before:
                style: dict[str, Any] = {"color": line.get_color(), "label": f"{title}, before"}
                ax.plot(values["depth"], before, ":", **style)
        widest = self._widest
        ax.axhline(0.0, color="0.7", linewidth=0.8)
        ax.set_xlim(0.0, 5.0 * widest if widest > 0.0 else None)
        ax.set(xlabel=self._depth_at(values), ylabel=f"stress left [{self._stress}]")
        ax.legend(frameon=False)
        return ax

    def passes(self, quantity: str = "net_strain", step: int = -1, ax: Axes | None = None) -> Axes:
        """A figure of both bodies over the passes of a load that rolls: `net_strain`,
        `pass_strain`, `track_depth`, `least_sigma_x`, or another of `passes`.
        """
        ax = _axes(ax)
        passes = self._rolling(step).passes
        names = [side for side in COLOURS if f"{side}_{quantity}" in passes]
        if not names:
            parts = [
                name.split("_", 1) for name in map(str, passes) if not name.endswith("_error")
            ]
            known = sorted({name for side, *rest in parts if side in COLOURS for name in rest})
            raise BrinellError(f"no {quantity!r} of a body; there are {', '.join(known)}")
        # Where both bodies are alike one line hides the other, so that the second is dashed.
        for name, line in zip(names, ("o-", "s--"), strict=False):
            values = passes[f"{name}_{quantity}"]
            style: dict[str, Any] = {"color": COLOURS[name], "markersize": 3}
            ax.plot(values.index, values, line, label=f"{name} body", **style)
        if quantity in ("net_strain", "pass_strain") and (ax.get_ylim()[1] > 0.0):
            ax.set_yscale("log", nonpositive="mask")
        unit = self._result.steps[step].row(quantity).unit
        title = quantity.replace("_", " ") + (f" [{unit}]" if unit else "")
        ax.set(xlabel="pass", ylabel=title)
        ax.legend(frameon=False)
        return ax

    def shakedown_map(self, step: int = -1, ax: Axes | None = None) -> Axes:
        """Limits of first yield and of shakedown over friction, and where this job is.

        The ordinate is Hertz's peak pressure over the yield stress in shear.
        """
        ax = _axes(ax)
        one = self._rolling(step)
        curve = one.data.get("shakedown")
        k = one.get("shear_yield_stress")
        if not (k > 0.0 and curve):
            raise BrinellError("no body of this job has a yield point, which limits are over")
        for name, (words, line) in LIMITS.items():
            columns = zip(curve["friction"], curve[name], strict=False)
            known = [(friction, peak / k) for friction, peak in columns if peak]
            # Of ellipses the limit of perfect plasticity is known in free rolling alone.
            ax.plot(*zip(*known, strict=True), line if len(known) > 1 else "s", label=words)
        here = one.row("peak_pressure").elastic / k
        ax.plot(abs(one["friction"]), here, "ko", label="this job")
        ax.set(xlabel="friction |μ|", ylabel="Hertz's peak over k")
        ax.set_ylim(bottom=0.0)
        ax.legend(frameon=False)
        return ax

    def _rolling(self, step: int) -> Step:
        one = self._result.steps[step]
        if "passes" not in one.data:
            raise BrinellError('the load of this step does not roll: rolling={"force": 2000}')
        return one

    def field(
        self,
        name: str = "von_mises",
        step: int = -1,
        fields: Fields | None = None,
        scale: float = 1.0,
        ax: Axes | None = None,
    ) -> Axes:
        """A stress in both bodies near the contact, deformed `scale` times as much as they are."""
        ax = _axes(ax)
        fields = fields if fields is not None else self._result.fields(step)
        one = self._result.steps[step]
        whole = [body.whole() for body in fields.bodies]
        low = min(float(body[name].min()) for body in whole)
        high = max(float(body[name].max()) for body in whole)
        drawn: Any = None
        for body in whole:
            drawn = _draw(ax, body, name, scale, one.approach, low, high)
        reach = (one.half_width if one.half_width > 0.0 else self._widest) / CONTACT_PART
        ax.set(xlim=(-reach, reach), ylim=(-reach, reach), aspect="equal")
        ax.set(xlabel=f"x [{self._length}]", ylabel=f"y [{self._length}]")
        unit = "" if name in WITHOUT_UNIT else f" [{self._stress}]"
        if drawn is not None and ax.figure is not None:
            ax.figure.colorbar(drawn, ax=ax, label=self._titles.get(name, name) + unit)
        return ax

    def load_approach(self, ax: Axes | None = None) -> Axes:
        """Force over approach: the curve of a sweep, the loop of a history."""
        ax = _axes(ax)
        curve = self._result.data.get("load_approach")
        steps = self._result.steps
        if curve:
            ax.plot(curve["approach"], curve["force"], "-")
        ends = np.array([(step.approach, step.get("force")) for step in steps])
        ax.plot(*ends.T, "o", color="C0", markersize=3)
        ax.set(
            xlabel=f"approach [{self._length}]", ylabel=f"force [{unit_of_force(self._result)}]"
        )
        return ax

    def hardness(self, ax: Axes | None = None) -> Axes:
        """Load-displacement curve of a hardness test, with the number and Oliver and Pharr's
        slope.
        """
        ax = _axes(ax)
        curve = self._result.hardness_curve
        found = self._result.row("hardness")
        said = f"{found.label}: {found.value:.4g} {found.unit}".rstrip()
        if found.error > 0.0:
            said += f" ± {100 * found.error:.1f} %"
        ax.plot(curve["displacement"], curve["force"], ".-", markersize=3, label=said)
        if (stiffness := self._result.get("oliver_pharr_stiffness")) > 0.0:
            height, most = curve[["displacement", "force"]].to_numpy()[curve["force"].argmax()]
            foot = height - most / stiffness
            words = "slope of unloading, Oliver and Pharr"
            ax.plot([foot, height], [0.0, most], "k:", label=words)
        ax.set(
            xlabel=f"displacement [{self._length}]",
            ylabel=f"force [{unit_of_force(self._result)}]",
        )
        ax.set_ylim(bottom=0.0)
        ax.legend(frameon=False)
        return ax

    def dent(self, step: int = -1, ax: Axes | None = None) -> Axes:
        """Both surfaces beside their undeformed shape (theory `flow`): dent and pile-up where the
        load is zero.
        """
        ax = _axes(ax)
        bodies = self._result.steps[step].data.get("surfaces")
        if not bodies:
            raise BrinellError(f"only flow theory knows dents: {UNLOAD}")
        factor, unit = (1e6, "µm") if self._result.units == "SI" else (1e3, "µm")
        surfaces = {name: surface for name, surface in bodies.items() if surface}
        for (name, surface), line in zip(surfaces.items(), ("-", "--"), strict=False):
            height = factor * np.asarray(surface["height"])
            ax.plot(surface["x"], height, line, color=COLOURS[name], label=f"{name} body")
        widest = self._widest
        ax.axhline(0.0, color="0.7", linewidth=0.8)
        if widest > 0.0:
            ax.set_xlim(-3.0 * widest, 3.0 * widest)
        ax.set(xlabel=f"x [{self._length}]", ylabel=f"height [{unit}]")
        ax.legend(frameon=False)
        return ax


def _axes(ax: Axes | None) -> Axes:
    if ax is not None:
        return ax
    pyplot = need("matplotlib.pyplot", "plot")
    made: Axes = pyplot.subplots(layout="constrained")[1]
    return made


def _draw(
    ax: Axes, body: BodyFields, name: str, scale: float, approach: float, low: float, high: float
) -> Any:
    """One body, each element as two triangles."""
    x, y = (body.nodes + scale * body.displacement).astype(float).T
    # Displacements are relative to the supports, and that of the upper body comes down by the
    # approach.
    if body.name == "upper":
        y = y - scale * approach
    a, b, c, d = body.elements.astype(np.int64).T
    triangles = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    mesh = need("matplotlib.tri", "plot").Triangulation(x, y, triangles)
    return ax.tripcolor(mesh, body[name].astype(float), shading="gouraud", vmin=low, vmax=high)
