"""Tables of laboratories, the cases that the page's reader meets too."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT

from brinell import Client, InvalidJob, hardening

CASES = json.loads((ROOT / "tests/measured/tables.json").read_text("utf-8"))


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["name"])
def test_a_table_is_read_or_asked_about(case: dict[str, Any], tmp_path: Path) -> None:
    path = tmp_path / "table.txt"
    path.write_text(case["text"], "utf-8", newline="")
    if "asks" in case:
        with pytest.raises(InvalidJob, match=case["asks"]):
            hardening.read_table(path)
    if "points" not in case:
        return
    record = hardening.read_table(path, **case.get("given", {}))
    assert len(record.points) == case["points"]
    is_test = case["kind"] == "curve"
    assert record.measure == (case.get("measure", "plastic") if is_test else None)
    assert (record.scale or None) == case.get("scale")
    assert record.points[0] == pytest.approx(case["first"], rel=1e-9, abs=1e-12)
    assert record.points[-1] == pytest.approx(case["last"], rel=1e-9)


def test_a_file_of_a_test_is_a_law(client: Client, tmp_path: Path) -> None:
    path = tmp_path / "bluehill.csv"
    path.write_text(CASES[0]["text"], "cp1252", newline="")
    curve = hardening.from_tensile(path, young_modulus=205_000, client=client)
    assert curve.yield_stress == pytest.approx(420, rel=0.02)
    indentation = next(case for case in CASES if case.get("measure") == "indentation")
    path.write_text(indentation["text"], "utf-8")
    with pytest.raises(InvalidJob, match="indentation"):
        hardening.from_tensile(path)


@pytest.mark.parametrize(
    "given",
    [
        {"units": ["%"]},
        {"units": "%"},
        {"units": ["%", None]},
        {"young_modulus": None},
        {"section": "10"},
        {"section": float("nan")},
        {"gauge_length": -5},
    ],
)
def test_what_is_no_figure_and_no_unit_is_said(given: dict[str, Any], tmp_path: Path) -> None:
    path = tmp_path / "table.txt"
    path.write_text(CASES[0]["text"], "utf-8")
    with pytest.raises(InvalidJob, match=next(iter(given))):
        hardening.read_table(path, **given)
