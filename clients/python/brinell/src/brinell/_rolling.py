"""The passes of a load that rolls, and what becomes of the track."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from ._plain import need

if TYPE_CHECKING:
    import pandas as pd


class Rolling:
    """What a load that rolls does to its track. Unknown figures are NaN."""

    def __init__(self, data: dict[str, Any]) -> None:
        self.data = data
        """The member `rolling` of the step as the service sends it."""

    @property
    def verdict(self) -> str:
        """`elastic`, `shakes_down`, `closed_cycle`, `undecided` or `ratchets`."""
        return str(self.data["verdict"])

    @property
    def body(self) -> str | None:
        """The body of which it is said; None of both."""
        return self.data.get("body")

    @property
    def rate(self) -> float:
        """The plastic strain of a steady pass: what a track that ratchets gains, what one that
        closes a cycle accumulates, 0 of one that shakes down.
        """
        return _number(self.data.get("rate"))

    @property
    def rate_error(self) -> float:
        """The estimated error of the rate, in its unit."""
        return _number(self.data.get("rate_error"))

    @property
    def reason(self) -> str | None:
        """Why the verdict is open or the passes end."""
        return self.data.get("reason")

    @property
    def friction(self) -> float:
        """Traction over pressure, positive along the travel on the lower body."""
        return _number(self.data.get("friction"))

    @property
    def limits(self) -> dict[str, Any]:
        """Elastic peak pressures up to which the track shakes down: `perfect`, `kinematic`, and
        the same `over_friction`, beside the yield stress in shear.
        """
        return self.data["limits"] or {}

    @property
    def passes(self) -> pd.DataFrame:
        """A row for each pass, by its number. Figures of a body are `lower_groove_depth` and so
        on, relative errors end with `_error`.
        """
        pandas = need("pandas", "pandas")
        rows = [_row(one) for one in self.data["passes"]]
        frame: pd.DataFrame = pandas.DataFrame(rows)
        return frame.set_index("number") if rows else frame

    def __repr__(self) -> str:
        return f"<rolling: {self.verdict}, {len(self.data['passes'])} passes>"


def _row(one: dict[str, Any]) -> dict[str, Any]:
    row = {name: value for name, value in one.items() if name not in ("bodies", "estimated_error")}
    errors = one.get("estimated_error") or {}
    for side, body in one["bodies"].items():
        row.update({f"{side}_{name}": value for name, value in (body or {}).items()})
    for name, error in errors.items():
        if name != "bodies":
            row[f"{name}_error"] = _number(error)
    for side, body in (errors.get("bodies") or {}).items():
        row.update(
            {f"{side}_{name}_error": _number(error) for name, error in (body or {}).items()}
        )
    return row


def _number(value: float | None) -> float:
    return math.nan if value is None else float(value)
