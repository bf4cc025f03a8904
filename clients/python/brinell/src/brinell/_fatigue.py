"""High-cycle fatigue of the bodies with limits: utilization by each criterion, over depth."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from ._errors import BrinellError
from ._plain import need
from ._rows import Row

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.axes import Axes

CRITERIA = {
    "dang_van": "Dang Van",
    "crossland": "Crossland",
    "orthogonal_shear": "orthogonal shear",
}


class Fatigue:
    """Whether the bodies of a step endure. A utilization of 1 is the limit."""

    def __init__(self, data: dict[str, Any]) -> None:
        self.data = data
        """The step as the service sends it."""

    @property
    def rows(self) -> list[Row]:
        """The rows of utilization, of each body by each criterion."""
        rows = map(Row.of, self.data["answers"])
        return [row for row in rows if row.name == "fatigue_utilization"]

    @property
    def utilization(self) -> dict[str, float]:
        """The largest utilization of both bodies and rules of hardening by each criterion; without
        those that are not known, and empty where the rule of the verdict knows none.
        """
        found: dict[str, float] = {}
        known = [row for row in self.rows if not math.isnan(row.value)]
        for row in known if any(not row.detail for row in known) else []:
            criterion = (row.at or {})["criterion"]
            found[criterion] = max(found.get(criterion, -math.inf), row.value)
        return found

    @property
    def reason(self) -> str | None:
        """Why the fatigue of a body is not known."""
        return next((row.reason for row in self.rows if math.isnan(row.value)), None)

    @property
    def over_depth(self) -> pd.DataFrame:
        """Utilization by each criterion over body and depth."""
        pandas = need("pandas", "pandas")
        bodies = {body: one for body, one in self.data["fatigue"].items() if one}
        if not bodies:
            raise BrinellError(f"this step has no fatigue: {self.reason}")
        frame: pd.DataFrame = pandas.concat(
            {body: pandas.DataFrame(one).set_index("depth") for body, one in bodies.items()},
            names=["body"],
        )
        return frame

    def __repr__(self) -> str:
        found = ", ".join(f"{CRITERIA[of]} {used:.2f}" for of, used in self.utilization.items())
        return f"<fatigue: {found or self.reason}>"


def draw(data: dict[str, Any], body: str, length: str, ax: Axes) -> Axes:
    """Utilization of a body over depth, with the limit."""
    curves = (data.get("fatigue") or {}).get(body)
    if not curves:
        raise BrinellError(f"this step has no fatigue of the {body} body: material(fatigue=...)")
    for name, title in CRITERIA.items():
        if curves[name] is not None:
            ax.plot(curves["depth"], curves[name], label=title)
    ax.axhline(1.0, color="0.7", linewidth=0.8)
    ax.set(xlabel=f"depth [{length}]", ylabel="utilization of the fatigue limit")
    ax.set_xlim(left=0.0)
    ax.legend(frameon=False)
    return ax
