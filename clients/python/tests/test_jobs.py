"""Jobs before they are sent."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pint
import pytest
from conftest import EXAMPLES, roller

import brinell
from brinell._plain import document_of, with_values


@pytest.mark.parametrize(
    ("build", "pointer"),
    [
        (lambda: brinell.cylinder(radius=-20, material=brinell.rigid), "#/radius"),
        (lambda: brinell.cylinder(radius="wide", material=brinell.rigid), "#/radius"),
        (
            lambda: brinell.cylinder(radius=5, material="S355", support="fixed"),
            "#/support",
        ),
        (lambda: brinell.swift(yield_stress=500, strain_offset=0.002, exponent=2), "#/exponent"),
        (lambda: brinell.material(young_modulus=2e5, poisson_ratio=0.5), "#/poisson_ratio"),
        (
            lambda: brinell.material(
                young_modulus=2e5, poisson_ratio=0.3, plasticity={"law": "voce", "yield_stress": 1}
            ),
            "#/plasticity/saturation_stress",
        ),
        (
            lambda: brinell.block(width=1, depth=1, material={"poisson_ratio": 0.3}),
            "#/material/young_modulus",
        ),
        (
            lambda: brinell.job(roller(), roller(), analysis="plane_strain", force=-1),
            "#/load/force",
        ),
        (
            lambda: brinell.job(
                roller(), roller(), analysis="plane_strain", force=np.linspace(1, 3, 3)
            ),
            "#/load/force",
        ),
        (lambda: brinell.job(roller(), roller(), analysis="plane_strain"), "#/load"),
        (lambda: brinell.job(roller(), roller(), analysis="plane", force=1), "#/analysis"),
        (
            lambda: brinell.job(roller(), roller(), analysis="plane_strain", forces=5),
            "#/load/forces",
        ),
        (
            lambda: brinell.job(roller(), roller(), analysis="plane_strain", history=[5, 0]),
            "#/load/history/0",
        ),
        (
            lambda: brinell.job(roller(), roller(), analysis="plane_strain", target={"peak": 5}),
            "#/load/target",
        ),
        (
            lambda: brinell.job(
                roller(), roller(), analysis="plane_strain", target={"peak_pressure": -5}
            ),
            "#/load/target/peak_pressure",
        ),
    ],
)
def test_mistakes_are_found_before_sending(build: Any, pointer: str) -> None:
    with pytest.raises(brinell.InvalidJob) as caught:
        build()
    assert pointer in [fault.pointer for fault in caught.value.errors]
    assert len(caught.value.errors) <= 2
    assert pointer in str(caught.value)


def test_every_fault_is_named() -> None:
    with pytest.raises(brinell.InvalidJob) as caught:
        brinell.block(width=-1, depth=0, material=brinell.rigid)
    assert {fault.pointer for fault in caught.value.errors} == {"#/width", "#/depth"}


def test_quantities_are_taken_in_their_units() -> None:
    q = pint.UnitRegistry().Quantity
    steel = brinell.material(
        young_modulus=q(210, "GPa"),
        poisson_ratio=0.3,
        plasticity=brinell.bilinear(yield_stress=q(5e8, "Pa"), tangent_modulus=q(10.5, "GPa")),
    )
    body = brinell.cylinder(radius=q(2, "cm"), material=steel)
    job = document_of(brinell.job(body, body, analysis="plane_strain", forces=q([1, 2], "kN/mm")))
    plain = document_of(
        brinell.job(roller(), roller(), analysis="plane_strain", forces=[1000, 2000])
    )
    assert json.dumps(job) == json.dumps(plain)
    sphere = document_of(brinell.job(body, body, analysis="axisymmetric", force=q(1, "kN")))
    assert sphere["load"] == {"force": 1000.0}
    si = with_values(
        {**job, "units": "SI"}, {"/upper/shape/radius": q(20, "mm"), "#/load/force": q(3, "N/mm")}
    )
    assert (si["upper"]["shape"]["radius"], si["load"]["force"]) == (0.02, 3000.0)
    with pytest.raises(pint.DimensionalityError):
        brinell.cylinder(radius=q(2, "MPa"), material=steel)


def test_arrays_are_taken() -> None:
    law = brinell.table(points=np.array([[0.0, 500.0], [0.01, 600.0]]))
    assert document_of({"a": law})["a"]["points"] == [[0.0, 500.0], [0.01, 600.0]]
    job = brinell.job(roller(), roller(), analysis="plane_strain", forces=np.linspace(100, 300, 3))
    assert document_of(job)["load"] == {"forces": [100.0, 200.0, 300.0]}


def test_files_dicts_and_models_are_the_same_job() -> None:
    path = EXAMPLES / "two_cylinders.json"
    by_dict = json.loads(path.read_text())
    assert document_of(path) == document_of(str(path)) == document_of(by_dict)
    with pytest.raises(TypeError, match="not int"):
        document_of(5)  # type: ignore[arg-type]


def test_values_are_set_by_pointer() -> None:
    job = {"load": {"forces": [1, 2]}, "upper": {"shape": {"radius": 1}}}
    made = with_values(
        job, {"/load/forces/1": 7, "#/solver/theory": "flow", "/upper/shape/radius": np.float64(3)}
    )
    assert made == {
        "load": {"forces": [1, 7]},
        "solver": {"theory": "flow"},
        "upper": {"shape": {"radius": 3.0}},
    }
    assert job["load"] == {"forces": [1, 2]}
    for bad in ("load/force", "", "force"):
        with pytest.raises(ValueError, match="a pointer begins with"):
            with_values(job, {bad: 1})
    with pytest.raises(ValueError, match="leads through a figure"):
        with_values(job, {"/upper/shape/radius/x": 1})


def test_materials_are_found_by_any_name() -> None:
    bearing = brinell.steels["52100"]
    assert bearing == brinell.materials["100cr6"] == brinell.materials[" 100Cr6"]
    named = brinell.cylinder(radius=1, material="52100")
    assert named == brinell.cylinder(radius=1, material=bearing)
    assert bearing.plasticity is not None
    assert bearing.plasticity.law == "swift"
    assert "945 MPa" in brinell.steels.source("52100")
    assert "CuSn7Zn2Pb3-C" in brinell.materials
    assert "CuSn7Zn2Pb3-C" not in brinell.steels
    with pytest.raises(KeyError, match="S355"):
        brinell.steels["unobtainium"]


def rough(heights: Any) -> dict[str, Any]:
    surface = {"heights": heights, "spacing_x": 0.01, "spacing_y": 0.01}
    flat = {"type": "flat"}
    return {
        "analysis": "three_dimensional",
        "upper": {"shape": flat, "material": {"rigid": True}, "surface": surface},
        "lower": {"shape": flat, "material": {"young_modulus": 210000, "poisson_ratio": 0.3}},
        "load": {"force": 1},
    }


def without(value: Any, keys: set[str]) -> Any:
    """A document without the members of these names."""
    if isinstance(value, dict):
        return {key: without(one, keys) for key, one in value.items() if key not in keys}
    return [without(one, keys) for one in value] if isinstance(value, list) else value


def test_heights_of_an_array_are_sent_as_numpy_writes_them(client: brinell.Client) -> None:
    x = np.linspace(-1, 1, 16)
    heights = 1e-3 * np.cos(5 * x)[:, None] * np.cos(7 * x[None, :] + 0.3)
    lists = client.solve(rough(heights.tolist()))
    unit = pint.UnitRegistry()
    for array in (heights, np.asfortranarray(heights), unit.Quantity(1e3 * heights, "um")):
        document = document_of(rough(array))
        assert list(document["upper"]["surface"]["heights"]) == ["npy_base64"]
        if not isinstance(array, np.ndarray):
            continue
        same = client.solve(document)
        timed = {"elapsed_ms", "timings_ms"}
        assert without(same.data, timed) == without(lists.data, timed)
    single = document_of(rough(heights.astype(np.float32)))["upper"]["surface"]["heights"]
    double = document_of(rough(heights))["upper"]["surface"]["heights"]
    assert len(single["npy_base64"]) < 0.8 * len(double["npy_base64"])


def test_holes_of_an_array_are_named() -> None:
    heights = np.zeros((8, 8))
    heights[2, 3] = np.nan
    with pytest.raises(brinell.InvalidJob) as caught:
        document_of(rough(heights))
    assert [fault.pointer for fault in caught.value.errors] == ["#/upper/surface/heights/2/3"]


def test_a_moment_has_a_unit() -> None:
    unit = pint.UnitRegistry()
    body = brinell.roller(
        radius=5, length=10, moment=unit.Quantity(2, "N*m"), material=brinell.rigid
    )
    assert document_of({"upper": body})["upper"]["shape"]["moment"] == pytest.approx(2000)


def test_hardness_tests_bring_their_indenter(client: brinell.Client) -> None:
    steel = brinell.material(
        young_modulus=208000,
        poisson_ratio=0.3,
        plasticity=brinell.swift(yield_stress=650, strain_offset=0.0025, exponent=0.088),
    )
    result = client.solve(brinell.brinell_test(steel, elements_per_half_width=8))
    assert result.row("hardness").label == "HBW 10/3000"
    assert 200 < result["hardness"] < 300
    curve = result.hardness_curve
    assert list(curve) == ["step", "displacement", "force", "diameter", "mean_pressure"]
    assert curve["force"].max() == pytest.approx(3000 * 9.80665)
    assert curve.iloc[0].tolist()[:4] == [1, 0, 0, 0]
    assert curve["force"].iloc[-1] == 0
    drawn = result.plot.hardness()
    assert drawn.get_xlabel() == "displacement [mm]"
    assert drawn.get_legend().get_texts()[0].get_text().startswith("HBW 10/3000: 2")
    roller = brinell.cylinder(radius=5, material=brinell.rigid)
    body = brinell.block(width=40, depth=20, material=steel)
    other = brinell.job(
        roller, body, analysis="axisymmetric", force=100, elements_per_half_width=6
    )
    with pytest.raises(brinell.BrinellError, match="no hardness test"):
        _ = client.solve(other).hardness_curve
    for job, name in [
        (brinell.vickers(steel, elements_per_half_width=6), "HV 1"),
        (brinell.rockwell_c(steel, elements_per_half_width=6), "HRC"),
    ]:
        assert client.solve(job).row("hardness").label == name
    assert "hold" in _refused(client, {"scale": "HV", "force_kgf": 1, "hold": 10})


def _refused(client: brinell.Client, test: dict[str, Any]) -> str:
    specimen = {
        "shape": {"type": "block", "width": 4, "depth": 2},
        "material": {"young_modulus": 208000, "poisson_ratio": 0.3},
    }
    with pytest.raises(brinell.InvalidJob) as refused:
        client.solve({"lower": specimen, "load": {"hardness": test}})
    return str(refused.value)
