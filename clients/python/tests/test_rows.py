"""Figures by name, of rows as docs/adr/0076 has them."""

from __future__ import annotations

import math
from typing import Any

import pytest

from brinell import BrinellError, Result

ROW = {
    "name": "max_plastic_strain",
    "label": "Largest plastic strain",
    "body": "lower",
    "value": 0.00312,
    "quantity": "strain",
    "unit": "",
    "error": 0.021,
    "elastic": 0.0,
    "place": {"body": "lower", "x": 0.0, "depth": 0.31},
    "text": "of all integration points",
    "detail": False,
}


def result(*rows: dict[str, Any], beside: list[dict[str, Any]] | None = None) -> Result:
    """A result of one step with these members over those of the row above."""
    step = {
        "status": "converged",
        "answers": [{**ROW, **row} for row in rows],
        "verdict": {"level": "yields", "text": "The lower body yields."},
        "validity": [{"code": "half_space", "message": "It is one."}],
    }
    report = {
        "status": "converged",
        "units": "mm_N_MPa",
        "analysis": "plane_strain",
        "steps": [step],
        "answers": [{**ROW, **row} for row in beside or []],
    }
    return Result(report)


def test_the_first_row_of_a_name_is_meant_unless_a_body_is_named() -> None:
    found = result({}, {"body": "upper", "value": 0.001, "detail": True})
    assert found["max_plastic_strain"] == 0.00312
    assert found.row("max_plastic_strain", "upper").value == 0.001
    with pytest.raises(KeyError, match="of the both body; there are max_plastic_strain"):
        found.row("max_plastic_strain", "both")
    assert list(found.rows["body"]) == ["lower", "upper"]


def test_an_error_is_a_bound_or_has_a_reason() -> None:
    for said, bound, reason in [
        ({"error": 0.021}, 0.021, ""),
        ({"error": "given"}, 0.0, "given"),
        ({"error": "exact"}, 0.0, "exact"),
        ({"error": "not_bounded", "reason": "one mesh"}, math.nan, "one mesh"),
    ]:
        row = result(said).row("max_plastic_strain")
        assert (row.error, row.reason) == (pytest.approx(bound, nan_ok=True), reason)


def test_what_is_not_known_is_nan_and_has_its_bounds_in_words() -> None:
    found = result({"value": None, "error": "not_bounded", "at_least": 0.002, "elastic": None})
    assert math.isnan(found["max_plastic_strain"])
    assert "Largest plastic strain not known % ≥ 0.2" in " ".join(repr(found).split())
    assert found.get("dent_depth", "max_plastic_strain") is math.nan


def test_a_line_of_a_table_has_every_row_once() -> None:
    rule = {"name": "strain_per_pass", "body": "both", "at": {"pass": 25}}
    found = result(
        {},
        {**rule, "at": {"pass": 25, "hardening": "kinematic"}},
        {"name": "force", "body": None, "error": "given", "elastic": None},
        beside=[{"name": "hardness", "body": None, "label": "HBW 10/3000", "elastic": None}],
    )
    assert found.line == {
        "status": "converged",
        "hardness": 0.00312,
        "hardness_error": 0.021,
        "lower_max_plastic_strain": 0.00312,
        "lower_max_plastic_strain_error": 0.021,
        "lower_max_plastic_strain_elastic": 0.0,
        "strain_per_pass_kinematic": 0.00312,
        "strain_per_pass_kinematic_error": 0.021,
        "strain_per_pass_kinematic_elastic": 0.0,
        "force": 0.00312,
        "force_error": 0.0,
        "remarks": "half_space",
    }
    assert list(found.summary["force"]) == [0.00312]


def test_a_result_of_an_older_version_is_to_be_solved_again() -> None:
    old = Result({"status": "converged", "version": "0.2.0", "steps": [{"hertz": None}]})
    assert old.line == {"status": "failed", "remarks": ""}
    with pytest.raises(BrinellError, match=r"version 0\.2\.0.*solve it again"):
        _ = old["peak_pressure"]
