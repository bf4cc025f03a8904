"""Whether bodies with limits of fatigue endure."""

from __future__ import annotations

import pytest

import brinell
from brinell import BrinellError, Client, Result

TORSION = 350.0


@pytest.fixture(scope="module")
def rollers(client: Client) -> Result:
    """Elastic rollers under Hertz's 1500 MPa; Dang Van's weight is 0.25."""
    steel = brinell.material(
        young_modulus=210000, poisson_ratio=0.3, fatigue={"torsion": TORSION, "bending": 600}
    )
    roller = brinell.cylinder(radius=20, material=steel)
    return client.solve(brinell.job(roller, roller, analysis="plane_strain", force=612.6106))


def test_utilizations_are_those_of_hertz(rollers: Result) -> None:
    fatigue = rollers.fatigue
    assert fatigue is not None
    assert fatigue.reason is None
    used = fatigue.utilization
    assert used["orthogonal_shear"] * TORSION == pytest.approx(0.25 * 1500, rel=0.01)
    assert used["dang_van"] * TORSION == pytest.approx(0.1818 * 1500, rel=0.01)
    assert repr(fatigue).startswith("<fatigue: Dang Van 0.78, Crossland ")
    over_depth = fatigue.over_depth
    assert over_depth.loc["lower", "dang_van"].max() == pytest.approx(used["dang_van"])
    assert set(over_depth.index.get_level_values("body")) == {"upper", "lower"}


def test_curves_stand_beside_the_limit(rollers: Result) -> None:
    axes = rollers.plot.fatigue()
    lines = {line.get_label(): line for line in axes.lines}
    assert {"Dang Van", "Crossland", "orthogonal shear"} <= set(lines)
    assert max(lines["orthogonal shear"].get_ydata()) == pytest.approx(1.071, rel=0.01)


def test_there_is_none_without_limits(dent: Result) -> None:
    assert dent.fatigue is None
    with pytest.raises(BrinellError, match="no fatigue of the lower body"):
        dent.plot.fatigue()
