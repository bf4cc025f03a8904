"""Hardening curves and cases from measurements."""

from __future__ import annotations

from typing import Any

import numpy as np
import pandas as pd
import pytest

import brinell
from brinell import Client, InvalidJob, hardening

MODULUS = 206_000.0


def record() -> tuple[Any, Any]:
    """Engineering strain and stress of steel with 500 MPa and a plastic modulus of 2 GPa."""
    rise = np.linspace(0, 500, 40, endpoint=False)
    plastic = np.linspace(0, 0.05, 60)
    stress = np.concatenate([rise, 500 + 2000 * plastic])
    strain = np.concatenate([rise / MODULUS, plastic + (500 + 2000 * plastic) / MODULUS])
    return np.expm1(strain), stress * np.exp(-strain)


def test_a_tensile_test_is_a_law(client: Client) -> None:
    strain, stress = record()
    curve = hardening.from_tensile(strain, stress, young_modulus=210_000, client=client)
    assert curve.points[0][1] == pytest.approx(500, rel=2e-3)
    assert curve.slope == pytest.approx(MODULUS, rel=1e-3)
    assert curve.remarks[0].startswith("The test rises with 206")
    steel = brinell.material(young_modulus=210_000, poisson_ratio=0.3, plasticity=curve.law)
    block = brinell.block(width=40, depth=20, material=steel)
    punch = brinell.cylinder(radius=20, material=brinell.rigid)
    job = brinell.job(punch, block, analysis="plane_strain", force=300)
    assert client.validate(job)["equations"] > 0


def test_per_cent_is_said_or_refused(client: Client) -> None:
    strain, stress = record()
    with pytest.raises(InvalidJob, match="per cent"):
        hardening.from_tensile(100 * strain, stress, young_modulus=210_000, client=client)
    curve = hardening.from_tensile(
        pd.Series(100 * strain), list(stress), strain_unit="percent", client=client
    )
    assert curve.yield_stress == pytest.approx(500, rel=2e-3)


def test_holes_are_named() -> None:
    strain, stress = record()
    masked = np.ma.masked_array(stress, mask=np.arange(len(stress)) == 7)
    missing = pd.Series(np.array(strain))
    missing[3] = None
    for columns, pointer in [
        ((strain, masked), "#/points/7/1"),
        ((missing, stress), "#/points/3/0"),
    ]:
        with pytest.raises(InvalidJob) as caught:
            hardening.from_tensile(*columns)
        assert [fault.pointer for fault in caught.value.errors] == [pointer]
    with pytest.raises(InvalidJob, match="100 strains and 99 stresses"):
        hardening.from_tensile(strain, stress[1:])
    with pytest.raises(InvalidJob):
        hardening.profile([0, 0.5], [720, None])


def test_a_case_has_the_limit_of_its_process() -> None:
    def limit(**given: Any) -> Any:
        return hardening.case(700, 300, 0.8, **given)["hardness"].get("limit")

    assert limit() is None
    assert limit(limit=610) == 610
    assert limit(limit="core+50") == 350
    assert limit(limit="80%") == pytest.approx(560)
    with pytest.raises(InvalidJob, match="rule of Vickers"):
        hardening.case(60, 30, 0.8, limit="80%", scale="HRC")
    with pytest.raises(InvalidJob, match="core\\+50"):
        hardening.case(700, 300, 0.8, limit="surface")  # type: ignore[arg-type]


def test_rockwell_is_taken_by_the_service(client: Client) -> None:
    def job(over_depth: Any) -> Any:
        law = brinell.swift(
            yield_stress=1000, strain_offset=0.002, exponent=0.08, over_depth=over_depth
        )
        steel = brinell.material(young_modulus=206_000, poisson_ratio=0.3, plasticity=law)
        roller = brinell.cylinder(radius=10, material=steel)
        return brinell.job(roller, roller, analysis="plane_strain", force=800)

    given = hardening.profile([0, 0.5, 1], [52.3, 49.1, 38.8], scale="HRC")
    vickers = hardening.profile([0, 0.5, 1], [550, 500, 380])
    peaks = [client.solve(job(one))["peak_pressure"] for one in (given, vickers)]
    assert peaks[0] == pytest.approx(peaks[1], rel=1e-12)
    drawn = hardening.case(58.8, 38.8, 0.8, scale="HRC")
    assert client.validate(job(drawn))["equations"] > 0


def test_a_modulus_that_is_no_number_is_named() -> None:
    for name in ("young_modulus", "offset"):
        with pytest.raises(brinell.InvalidJob, match=f"#/{name}: nan is no finite number"):
            brinell.hardening.from_tensile([0, 1], [0, 1], **{name: float("nan")})
