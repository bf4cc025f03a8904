"""What a result shows."""

from __future__ import annotations

import json
import pickle
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pytest
from conftest import EXAMPLES, roller

import brinell
from brinell import Client, Result


@pytest.fixture(scope="module")
def sweep(client: Client) -> Result:
    return client.solve(
        brinell.job(
            roller(),
            roller(),
            analysis="plane_strain",
            forces=[200, 400, 612.6106],
            theory="deformation",
        )
    )


def test_tables_have_a_row_for_each_step(sweep: Result) -> None:
    summary = sweep.summary
    assert summary.index.tolist() == [1, 2, 3]
    assert summary["force"].tolist() == pytest.approx([200, 400, 612.6106])
    assert summary["peak_pressure"].is_monotonic_increasing
    assert summary["peak_pressure"].iloc[-1] == sweep["peak_pressure"]
    assert (summary["peak_pressure_error"] > 0).all()
    assert summary["peak_pressure_elastic"].iloc[-1] == pytest.approx(1500, rel=1e-4)
    assert len(sweep.load_approach) >= 3
    depth = sweep.subsurface
    assert set(depth["body"]) == {"upper", "lower"}
    assert depth.loc[depth["body"] == "lower", "von_mises"].max() > 500


def test_pressure_is_arrays_that_carry_the_force(sweep: Result) -> None:
    pressure = sweep.pressure
    assert pressure.force.sum() == pytest.approx(sweep["force"], rel=1e-6)
    assert np.trapezoid(pressure.pressure, pressure.x) == pytest.approx(sweep["force"], rel=1e-2)
    assert pressure.to_xarray().pressure.max() == pytest.approx(sweep["peak_pressure"], rel=1e-2)
    assert list(pressure.to_frame()) == ["x", "pressure", "force", "gap"]


def test_a_result_is_kept_and_read_again(sweep: Result) -> None:
    for kept in (pickle.loads(pickle.dumps(sweep)), Result(json.loads(json.dumps(sweep.data)))):
        assert kept["peak_pressure"] == sweep["peak_pressure"]
        assert repr(kept) == repr(sweep)
        with pytest.raises(brinell.BrinellError, match="service"):
            kept.fields()


def test_a_dent_is_left(dent: Result) -> None:
    assert len(dent.steps) == 2
    assert dent.steps[0]["force"] == pytest.approx(612.6106)
    assert dent["force"] == 0
    assert dent["dent_depth"] > 1e-4
    assert dent.last.approach == dent["permanent_approach"]
    assert dent.surface["height"].min() < 0


def test_fields_are_those_of_the_document(client: Client, dent: Result) -> None:
    whole = client._run(
        client._core.json(
            "GET", f"/v1/jobs/{dent.id}/result", params={"fields": "fields", "step": "1"}
        )
    )
    said = whole["steps"][0]["fields"]["lower"]
    lower = dent.fields(0).lower
    assert lower is not None
    assert set(lower) == set(said)
    for name, values in said.items():
        np.testing.assert_allclose(
            lower[name], np.asarray(values), rtol=1e-6, atol=1e-4, err_msg=name
        )
    assert lower.symmetric
    both = lower.whole()
    assert len(both.nodes) == 2 * len(lower.nodes)
    for elements, nodes in ((lower.elements, lower.nodes), (both.elements, both.nodes)):
        a, b, c, d = (nodes[elements[:, k]] for k in range(4))
        area = np.cross(np.pad(c - a, ((0, 0), (0, 1))), np.pad(d - b, ((0, 0), (0, 1))))[:, 2]
        assert (area > 0).all(), "counter-clockwise"


def test_what_is_in_words_has_error_bars_and_remarks_on_top(client: Client, job: Any) -> None:
    good = client.solve(job)
    text, html = repr(good), good._repr_html_()
    assert text.startswith("converged, plane strain")
    assert "Hertz 1500" in text
    assert "±" in text
    assert "N/mm" in text
    assert "<table>" in html
    bad = client.solve({**brinell._plain.document_of(job), "solver": {"max_iterations": 1}})
    assert bad.status == "not_converged"
    assert bad.remarks[0].code == "not_converged"
    first = "<div><p>No answer: this load has not converged.</p><ul><li><code>not_converged</code>"
    assert bad._repr_html_().startswith(first)
    stopped = Result(None, error=brinell.InvalidJob([], "no <good>"))
    assert "no &lt;good&gt;" in stopped._repr_html_()
    assert "invalid" in repr(stopped)


def test_meshes_are_taken_to_pyvista(dent: Result) -> None:
    # Only the environment with every package has it.
    pytest.importorskip("pyvista")
    fields = dent.fields(0)
    lower = fields.lower
    assert lower is not None
    blocks = fields.to_pyvista()
    assert set(blocks.keys()) == {"upper", "lower"}
    grid = blocks["lower"]
    assert grid.n_cells == len(lower.elements)
    np.testing.assert_array_equal(grid.points[:, :2], lower.nodes)
    assert not grid.points[:, 2].any()
    np.testing.assert_array_equal(grid.point_data["von_mises"], lower["von_mises"])
    assert grid.point_data["displacement"].shape == (len(lower.nodes), 3)
    # Corners in their order: no cell is folded, and both halves are twice the one.
    areas = grid.compute_cell_sizes()["Area"]
    assert areas.min() > 0
    both = lower.whole().to_pyvista().compute_cell_sizes()["Area"]
    assert both.sum() == pytest.approx(2 * areas.sum())


@pytest.mark.parametrize(
    "name", ["pressure", "depth", "load_approach", "field", "dent", "residual_stress"]
)
def test_pictures_are_drawn(dent: Result, name: str) -> None:
    plot = getattr(dent.plot, name)
    ax = plot() if name not in ("pressure",) else plot(step=0)
    assert ax.get_xlabel()
    assert ax.get_ylabel()
    assert ax.has_data()
    ax.figure.canvas.draw()
    plt.close(ax.figure)


def test_what_cannot_be_drawn_says_why(sweep: Result, dent: Result) -> None:
    with pytest.raises(brinell.BrinellError, match="flow"):
        sweep.plot.dent()
    with pytest.raises(brinell.BrinellError, match="fields=True"):
        sweep.fields()
    with pytest.raises(brinell.BrinellError, match=r"there are .*von_mises"):
        sweep.plot.depth("mises")
    with pytest.raises(KeyError, match=r"there are .*von_mises"):
        dent.plot.field("mises")
    plt.close("all")


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.json")), ids=lambda path: path.stem)
@pytest.mark.full
def test_every_example_is_shown(client: Client, path: Any) -> None:
    result = client.solve(path)
    assert result.converged
    assert result._repr_html_()
    assert len(result.summary) == len(result.steps)
    assert result.report.status == "converged"
    result.plot.pressure(step=0)
    plt.close("all")


def test_what_is_left_is_not_said_of_a_load(dent: Result) -> None:
    loaded, unloaded = dent.steps
    assert np.isnan(loaded.get("dent_depth"))
    assert not loaded.unloaded
    assert unloaded.unloaded
    with pytest.raises(brinell.BrinellError, match="under load"):
        dent.plot.residual_stress(step=0)


def test_profiles_say_where_they_lie(dent: Result) -> None:
    assert (dent.subsurface["x"] == 0.0).all()
    for ax in (dent.plot.residual_stress(), dent.plot.depth()):
        assert ax.get_xlabel() == "depth [mm] at x = 0 mm"
        plt.close(ax.get_figure())
    place = dent.row("peak_pressure").place or {"x": 0.0}
    beside = dent.subsurface_below_peak
    assert beside.empty or (beside["x"] == place["x"]).all()


def test_results_on_the_same_axes_differ(dent: Result) -> None:
    ax = dent.plot.depth(step=0, body="upper", label="first")
    dent.plot.depth(step=0, body="upper", label="second", ax=ax)
    first, second = ax.get_lines()
    assert first.get_color() != second.get_color()
    assert [line.get_label() for line in (first, second)] == [
        "first, upper body",
        "second, upper body",
    ]
    plt.close(ax.get_figure())


def test_passes_of_a_load_that_rolls_are_a_table(client: Client) -> None:
    law = brinell.bilinear(yield_stress=500, tangent_modulus=0)
    steel = brinell.material(young_modulus=210000, poisson_ratio=0.3, plasticity=law)
    wheel = brinell.cylinder(radius=100, material=brinell.rigid)
    rail = brinell.block(width=100, depth=100, material=steel)
    load = {"force": 2000, "friction": 0.1, "passes": 12, "until": "passes"}
    result = client.solve(brinell.job(wheel, rail, analysis="plane_strain", rolling=load))
    passes = result.passes
    assert passes.index.tolist() == list(range(1, 13))
    assert passes["lower_pass_strain"].iloc[0] > 0
    assert (passes["lower_track_depth_error"].dropna() > 0).all()
    rule = result.last.data["rules"][-1]
    assert rule["verdict"] == result.verdict.level
    assert (result["strain_per_pass"] > 0) == (rule["verdict"] == "ratchets")
    residual = result.subsurface
    assert residual["depth"].is_monotonic_increasing
    assert residual["sigma_x"].min() < -10
    assert result["shakedown_pressure"] == pytest.approx(3.564 * 500 / 3**0.5, rel=1e-3)
    assert np.isnan(result.last.approach)
    assert client.solve(brinell.job(wheel, rail, analysis="plane_strain", force=10)).passes.empty


@pytest.fixture(scope="module")
def rolled(client: Client) -> Result:
    """A ball that runs in, with friction and initial stress."""
    job = json.loads((EXAMPLES / "ball_runs_in.json").read_text())
    job["load"]["rolling"].update(passes=3, friction=-0.1)
    job["mesh"] = {"elements_per_half_width": 5}
    job["lower"]["material"]["initial_stress"] = [
        {"depth": 0, "sigma_x": -100, "sigma_z": -150},
        {"depth": 5, "sigma_x": 0, "sigma_z": 0},
    ]
    return client.solve(job)


def test_passes_are_drawn(rolled: Result) -> None:
    for quantity, label in [
        ("net_strain", "net strain"),
        ("track_depth", "track depth [mm]"),
        ("least_sigma_x", "least sigma x [MPa]"),
    ]:
        ax = rolled.plot.passes(quantity)
        assert ax.get_ylabel() == label
        (line,) = ax.get_lines()
        assert list(line.get_xdata()) == [1, 2, 3]
        ax.figure.canvas.draw()
        plt.close(ax.get_figure())
    with pytest.raises(brinell.BrinellError, match=r"there are .*track_depth"):
        rolled.plot.passes("track")


def test_residual_stress_of_a_track_is_drawn_beside_that_before(rolled: Result) -> None:
    ax = rolled.plot.residual_stress()
    labels = [line.get_label() for line in ax.get_lines()]
    assert "stress along the travel" in labels
    assert "stress across the travel, before" in labels
    plt.close(ax.get_figure())


def test_the_map_of_shakedown_is_drawn(rolled: Result, sweep: Result) -> None:
    ax = rolled.plot.shakedown_map()
    lines = {line.get_label(): line for line in ax.get_lines()}
    (here,) = lines["this job"].get_xdata()
    assert here == pytest.approx(0.1)
    assert len(lines["shakedown, perfectly plastic"].get_xdata()) == 1
    first, kinematic = (
        np.asarray(lines[name].get_ydata(), dtype=float)
        for name in ("first yield", "shakedown, kinematic hardening")
    )
    assert (first < kinematic).all()
    ax.figure.canvas.draw()
    plt.close(ax.get_figure())
    with pytest.raises(brinell.BrinellError, match="does not roll"):
        sweep.plot.shakedown_map()


def test_a_result_is_a_file_and_comes_back(dent: brinell.Result, tmp_path: Path) -> None:
    copy = dent.to_dict()
    copy["steps"].clear()
    assert len(dent.steps) == 2
    dent.save(tmp_path / "dent.json", fields=True)
    again = brinell.Result.load(tmp_path / "dent.json")
    assert again.data == dent.data
    kept, lower = again.fields().lower, dent.fields().lower
    assert kept is not None
    assert lower is not None
    assert (kept["sigma_x"] == lower["sigma_x"]).all()
    dent.save(tmp_path / "figures.json")
    with pytest.raises(brinell.BrinellError, match="fields=True"):
        brinell.Result.load(tmp_path / "figures.json").fields()
    tree = dent.fields().to_xarray()
    assert tree["lower/von_mises"].sizes == {"node": len(lower.nodes)}
    assert (tree["lower/y"] <= 0.01).all()
