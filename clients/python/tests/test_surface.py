"""Measured surfaces: files as instruments write them, holes, units, thinning."""

from __future__ import annotations

import json
import re
import runpy
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pint
import pytest
import xarray
from conftest import ROOT

import brinell
from brinell._grid_text import NotUnderstood, read_grid
from brinell._plain import document_of
from brinell._surface import _text_of

CASES = json.loads((ROOT / "tests/measured/grids.json").read_text("utf-8"))


@pytest.mark.parametrize("case", CASES, ids=[case["name"] for case in CASES])
def test_a_text_is_understood_or_refused(case: dict[str, Any]) -> None:
    text = _text_of(case["text"].encode(case["encoding"]))
    assert text is not None
    if "refused" in case:
        with pytest.raises(NotUnderstood, match=r".") as caught:
            read_grid(text)
        assert case["refused"] in str(caught.value)
        if "line" in case:
            read_grid(text, (case["line"],))
        return
    grid = read_grid(text)
    assert list(grid.heights.shape) == case["shape"]
    assert (grid.across, grid.up) == (case["across"], case["up"])
    if case["spacing"] is None:
        assert grid.spacing is None
    else:
        assert grid.spacing == pytest.approx(case["spacing"])
    assert np.count_nonzero(np.isnan(grid.heights)) == case["missing"]
    if "corners" in case:
        ends = grid.heights[[0, 0, -1, -1], [0, -1, 0, -1]]
        assert ends == pytest.approx(case["corners"])
    assert case.get("says", "") in "; ".join(grid.notes)


def bumps(nx: int = 24, ny: int = 16) -> Any:
    """Heights in mm that no symmetry hides."""
    i, j = np.meshgrid(np.arange(nx), np.arange(ny), indexing="ij")
    return 1e-3 * (np.sin(0.7 * i + 0.3) + 0.5 * np.cos(0.9 * j) + 0.02 * i - 0.01 * j)


def faults(error: pytest.ExceptionInfo[brinell.InvalidJob]) -> str:
    return "; ".join(fault.detail for fault in error.value.errors)


@pytest.mark.parametrize(
    "missing",
    [
        lambda: np.ma.masked_array([[0, 500.0], [0.01, 600]], mask=[[0, 0], [0, 1]]),
        lambda: pd.DataFrame({"strain": [0, 0.01], "stress": [500.0, None]}),
        lambda: pd.DataFrame({"a": [0, 0.01], "b": pd.array([500, pd.NA], dtype="Int64")}),
        lambda: xarray.DataArray([[0, 500.0], [0.01, np.nan]]),
        lambda: [[0, 500.0], [0.01, np.ma.masked]],
        lambda: [[0, 500.0], [0.01, pd.NA]],
    ],
)
def test_holes_of_a_table_are_named(missing: Any) -> None:
    with pytest.raises(brinell.InvalidJob) as caught:
        brinell.table(points=missing())
    assert [fault.pointer for fault in caught.value.errors] == ["#/points/1/1"]
    with pytest.raises(brinell.InvalidJob) as caught:
        document_of({"upper": {"material": {"plasticity": {"law": "table", "points": missing()}}}})
    assert caught.value.errors[0].pointer.endswith("/points/1/1")


def test_missing_loads_are_named() -> None:
    unit = pint.UnitRegistry()
    masked = np.ma.masked_array([1.0, 2.0], mask=[0, 1])
    for forces in (pd.Series([1, pd.NA], dtype="Int64"), masked, unit.Quantity(masked, "N/mm")):
        with pytest.raises(brinell.InvalidJob) as caught:
            document_of({"load": {"forces": forces}})
        assert [fault.pointer for fault in caught.value.errors] == ["#/load/forces/1"]


@pytest.mark.parametrize(
    "kind", [np.ma.masked_invalid, pd.DataFrame, pint.UnitRegistry().Quantity, np.asarray]
)
def test_holes_of_heights_are_one_fault(kind: Any) -> None:
    heights = bumps()
    heights[3, 4:7] = np.nan
    array = kind(heights, "mm") if "Quantity" in str(kind) else kind(heights)
    flat = {"type": "flat"}
    surface = {"heights": array, "spacing_x": 0.01, "spacing_y": 0.01}
    with pytest.raises(brinell.InvalidJob) as caught:
        document_of({"upper": {"shape": flat, "surface": surface}})
    assert [fault.pointer for fault in caught.value.errors] == ["#/upper/surface/heights/3/4"]
    assert "3 of 384 heights are missing, the first at [3, 4]" in faults(caught)


def test_a_surface_names_its_holes_and_fills_them_when_told(client: brinell.Client) -> None:
    x = np.linspace(-1, 1, 32)
    heights = np.ma.masked_array(-0.002 * (x[:, None] ** 2 + x[None, :] ** 2))
    heights[3, 4] = 0.05
    heights[3, 4] = np.ma.masked
    holed = brinell.surface(heights, spacing=0.03)
    assert "1 of 1 024 heights are missing, the first at [3, 4]" in repr(holed)
    steel = {"young_modulus": 210000, "poisson_ratio": 0.3}
    job = {
        "analysis": "three_dimensional",
        "upper": {"shape": {"type": "flat"}, "material": {"rigid": True}, "surface": holed},
        "lower": {"shape": {"type": "flat"}, "material": steel},
        "load": {"force": 1},
    }
    with pytest.raises(brinell.InvalidJob) as caught:
        client.solve(job)
    assert caught.value.errors[0].pointer == "#/upper/surface/heights/3/4"
    filled = brinell.surface(heights, spacing=0.03, fill="harmonic")
    around = heights[[2, 4, 3, 3], [4, 4, 3, 5]]
    assert filled.heights[3, 4] == pytest.approx(float(around.mean()))
    job["upper"]["surface"] = filled  # type: ignore[index]
    assert client.solve(job).converged
    si = document_of({"units": "SI", "analysis": "three_dimensional", "upper": job["upper"]})
    assert si["upper"]["surface"]["spacing_x"] == pytest.approx(3e-5)


def test_a_large_hole_is_filled_as_a_skin() -> None:
    i, j = np.meshgrid(np.arange(40.0), np.arange(30.0), indexing="ij")
    skin = i * i - j * j + 3 * i * j
    holed = skin.copy()
    holed[10:25, 8:20] = np.nan
    assert brinell.surface(holed, spacing=1, fill="harmonic").heights == pytest.approx(skin)
    with pytest.raises(brinell.InvalidJob, match="all heights are missing"):
        brinell.surface(np.full((9, 9), np.nan), spacing=1, fill="harmonic")


@pytest.mark.parametrize("figure", [-9999.0, 1.70141e38, 99999.0, 1e10])
def test_figures_that_stand_for_no_data_are_refused(figure: float) -> None:
    heights = bumps()
    heights[5:8, 6:9] = figure
    with pytest.raises(brinell.InvalidJob) as caught:
        brinell.surface(heights, spacing=1)
    assert "9 of 384 heights are" in faults(caught)
    assert "the first at [5, 6]" in faults(caught)
    told = brinell.surface(heights, spacing=1, no_data=figure)
    assert told.missing == 9
    assert brinell.surface(heights, spacing=1, no_data=None).missing == 0


def test_blocks_of_one_value_are_named() -> None:
    heights = bumps()
    heights[5:10, 6:12] = 0
    with pytest.warns(UserWarning, match="30 of 384 heights are 0 mm in blocks"):
        brinell.surface(heights, spacing=1)
    apart = bumps() + 5
    apart[[3, 8, 12], [4, 9, 2]] = 0
    with pytest.warns(UserWarning, match="3 of 384 heights are 0 mm, further from all others"):
        brinell.surface(apart, spacing=1)
    steps = np.where(bumps() > 0, 0.0, -1.0)
    assert brinell.surface(steps, spacing=1).notes == ()
    flat_tops = np.minimum(bumps(), 0.5e-3)
    with pytest.warns(UserWarning, match="in blocks"):
        brinell.surface(flat_tops, spacing=1)
    assert brinell.surface(bumps(), spacing=1).notes == ()


def test_levels() -> None:
    i, j = np.meshgrid(np.arange(20.0), np.arange(15.0), indexing="ij")
    tilted = brinell.surface(3 + 0.2 * i - 0.1 * j, spacing=0.5, level="plane")
    assert np.abs(tilted.heights).max() < 1e-12
    bowl = brinell.surface(3 + 0.2 * i * i - 0.1 * i * j, spacing=0.5, level="paraboloid")
    assert np.abs(bowl.heights).max() < 1e-11
    assert brinell.surface(bumps(), spacing=1, level="mean").heights.mean() == pytest.approx(0)


def test_thinning_says_what_is_lost() -> None:
    noise = np.random.default_rng(1).normal(size=(120, 90)) * 1e-3
    whole = brinell.surface(noise, spacing=0.001)
    thin = brinell.surface(noise, spacing=0.001, size=60)
    assert thin.heights == pytest.approx(noise.reshape(60, 2, 45, 2).mean(axis=(1, 3)))
    assert thin.spacing == pytest.approx((0.002, 0.002))
    # White noise: the mean of four has half the height, over twice the distance.
    assert thin.rms_height == pytest.approx(whole.rms_height / 2, rel=0.05)
    assert thin.rms_slope == pytest.approx(whole.rms_slope / 4, rel=0.05)
    assert "(76 % of it lost)" in repr(thin)
    by_cell = brinell.surface(noise, spacing=0.001, cell=0.0025)
    assert by_cell.heights.shape == (48, 36)
    assert by_cell.heights.mean() == pytest.approx(noise.mean())
    odd = brinell.surface(noise, spacing=0.001, cell=0.007)
    assert odd.heights.shape == (17, 12)
    # 119 of 120 are in whole cells: half a height at each end is not.
    assert odd.heights[0, 0] != odd.heights[1, 0]
    with pytest.raises(ValueError, match="finer than those measured"):
        brinell.surface(noise, spacing=0.001, cell=0.0005)
    assert "size=512 thins them" in repr(brinell.surface(np.zeros((600, 9)), spacing=1))
    assert whole.cropped(64).heights == pytest.approx(noise[28:92, 13:77])


def test_arrays_of_xarray_bring_places_and_units() -> None:
    heights = 1e3 * bumps()
    array = xarray.DataArray(
        heights.T[::-1],
        dims=("y", "x"),
        coords={"y": 0.25 * np.arange(16)[::-1], "x": 0.5 * np.arange(24)},
        attrs={"units": "µm"},
    )
    with pytest.raises(brinell.InvalidJob, match="says no unit of its distances"):
        brinell.surface(array)
    for axis in ("x", "y"):
        array.coords[axis].attrs["units"] = "mm"
    found = brinell.surface(array)
    assert found.heights == pytest.approx(bumps())
    assert found.spacing == pytest.approx((0.5, 0.25))
    assert brinell.surface(array.to_dataset(name="z")).heights == pytest.approx(bumps())
    uneven = array.assign_coords(x=np.arange(24) ** 1.5)
    with pytest.raises(brinell.InvalidJob, match="does not rise by equal steps"):
        brinell.surface(uneven)
    plain = {"heights": xarray.DataArray(bumps().T, dims=("y", "x"))}
    lists = {"heights": bumps()}
    assert document_of(plain) == document_of(lists)


def test_what_lacks_is_named() -> None:
    with pytest.raises(brinell.InvalidJob, match=r"no distance of its heights"):
        brinell.surface(bumps())
    with pytest.raises(brinell.InvalidJob, match="two dimensions"):
        brinell.surface(np.zeros(9), spacing=1)
    with pytest.raises(brinell.InvalidJob, match="has to be positive"):
        brinell.surface(bumps(), spacing=-1)
    unit = pint.UnitRegistry()
    micro = brinell.surface(
        unit.Quantity(1e3 * bumps(), "µm"), spacing=unit.Quantity([2, 3], "µm")
    )
    assert micro.heights == pytest.approx(bumps())
    assert micro.spacing == pytest.approx((0.002, 0.003))
    assert brinell.surface(bumps(), spacing=5, unit="µm").spacing == pytest.approx((0.005,) * 2)


def test_tables_of_points_are_put_on_a_grid() -> None:
    i, j = np.meshgrid(np.arange(24), np.arange(16), indexing="ij")
    table = pd.DataFrame({"x": 0.5 * i.ravel(), "y": 0.25 * j.ravel(), "z": bumps().ravel()})
    shuffled = table.sample(frac=1, random_state=1)
    found = brinell.surface(shuffled)
    assert found.heights == pytest.approx(bumps())
    assert found.spacing == pytest.approx((0.5, 0.25))
    with pytest.raises(brinell.InvalidJob, match="bring it"):
        brinell.surface(table, spacing=1)
    with pytest.raises(brinell.InvalidJob, match="one place"):
        brinell.surface(pd.concat([table, table[:1]]))


def test_packed_arrays_are_refused() -> None:
    packed = xarray.DataArray(np.ones((9, 9)), dims=("x", "y"), attrs={"scale_factor": 1e-3})
    with pytest.raises(brinell.InvalidJob, match="mask_and_scale"):
        brinell.surface(packed, spacing=1)


def test_files_bring_their_units(tmp_path: Path) -> None:
    path = tmp_path / "afm.txt"
    rows = "\n".join("\t".join(f"{z * 1e-3:.6e}" for z in line) for line in bumps().T[::-1])
    head = "# Channel: ZSensor\n# Width: 12 µm\n# Height: 4 µm\n# Value units: m\n"
    path.write_text(head + rows, "utf-8")
    found = brinell.surface(path)
    assert found.heights == pytest.approx(bumps(), abs=1e-9)
    assert found.spacing == pytest.approx((0.0005, 0.00025))
    with pytest.raises(brinell.InvalidJob, match=r"afm\.txt says 'm'"):
        brinell.surface(path, height_unit="nm")
    with pytest.raises(brinell.InvalidJob, match="spacing is given"):
        brinell.surface(path, spacing=1)
    np.save(tmp_path / "plain.npy", bumps())
    with pytest.raises(brinell.InvalidJob) as caught:
        brinell.surface(tmp_path / "plain.npy")
    assert len(caught.value.errors) == 3
    named = brinell.surface(tmp_path / "plain.npy", unit="µm", height_unit="mm", spacing=2)
    assert named.heights == pytest.approx(bumps())


def test_a_local_server_takes_the_largest_surface() -> None:
    x = np.linspace(-1, 1, 512)
    heights = -0.002 * (x[:, None] ** 2 + x[None, :] ** 2)
    flat = {"type": "flat"}
    steel = {"young_modulus": 210000, "poisson_ratio": 0.3}
    job = {
        "analysis": "three_dimensional",
        "upper": {
            "shape": flat,
            "material": {"rigid": True},
            "surface": brinell.surface(heights, spacing=0.002),
        },
        "lower": {"shape": flat, "material": steel},
        "load": {"force": 1},
    }
    with brinell.Client() as client:
        assert client.validate(job)["equations"] == 512**2
    with (
        brinell.Client(max_body=1 << 20, max_retries=0) as small,
        pytest.raises(brinell.ServiceError, match=r"1048576 bytes.*size=512"),
    ):
        small.validate(job)


def test_a_trace_is_levelled_filtered_and_thinned(tmp_path: Path) -> None:
    x = 0.5e-3 * np.arange(10_000)
    waves = 0.2 * x + 1e-3 * np.sin(2 * np.pi * x / 0.8) + 1e-4 * np.sin(2 * np.pi * x / 0.01)
    whole = brinell.trace(np.column_stack([x, waves]))
    assert whole.heights.max() == 0
    assert whole.x[np.argmax(whole.heights)] == 0
    assert np.polyfit(whole.x, whole.heights, 1)[0] == pytest.approx(0, abs=1e-9)
    # ISO 16610-21: half of a wave as long as the cut-off passes, none of one far shorter.
    half = brinell.trace(np.column_stack([x, waves - 0.2 * x]), level=False, cutoff=0.8)
    middle = np.abs(half.x - half.x.mean()) < 1.6
    assert np.ptp(half.heights[middle]) == pytest.approx(1e-3, rel=0.02)
    assert "ISO 16610-21, cut-off λ_c 800 µm" in repr(half)
    smooth = whole.filtered(0.08)
    assert np.ptp(np.diff(smooth.heights, 2)) < 1e-4
    thin = whole.thinned(500)
    assert len(thin.x) <= 501
    assert "of its slope Pdq lost" in repr(thin)
    with pytest.raises(brinell.InvalidJob, match="cutoff has to be between"):
        whole.filtered(9)
    holed = np.column_stack([x, waves])
    holed[100:120, 1] = np.nan
    with pytest.raises(brinell.InvalidJob, match="20 of 10 000 heights are missing"):
        brinell.trace(holed)
    assert "bridged" in repr(brinell.trace(holed, fill="linear"))
    path = tmp_path / "trace.csv"
    rows = [f"{a:.4f};{b * 1e3:.4f}".replace(".", ",") for a, b in zip(x, waves, strict=True)]
    path.write_text("Rauheit\r\nx [mm];z [µm]\r\n" + "\r\n".join(rows), "cp1252")
    assert brinell.trace(path).heights == pytest.approx(whole.heights, abs=1e-6)
    path.write_text("\n".join(rows))
    with pytest.raises(brinell.InvalidJob, match="it says no unit"):
        brinell.trace(path)


def test_a_trace_is_the_face_of_a_body(client: brinell.Client) -> None:
    x = 1e-3 * np.arange(4000)
    rng = np.random.default_rng(3)
    trace = brinell.trace(
        np.column_stack([x, 5 - (x - 2) ** 2 / 20 + 1e-4 * rng.normal(size=4000)]),
        level=False,
        cutoff=0.8,
    )
    steel = brinell.material(young_modulus=210000, poisson_ratio=0.3)
    body = brinell.profile(points=trace, depth=5, material=steel)
    block = brinell.block(width=20, depth=10, material=brinell.rigid)
    job = brinell.job(body, block, analysis="plane_strain", force=200, elements_per_half_width=6)
    assert client.solve(job).converged


def test_the_page_of_the_documents_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its blocks, one after the other, on files that are written here."""
    pytest.importorskip("SurfaceTopography")
    monkeypatch.chdir(tmp_path)
    runpy.run_path(str(ROOT / "clients/python/scripts/scans.py"))
    document = (ROOT / "docs/measured_surface.md").read_text("utf-8")
    blocks = re.findall(r"```python\n(.*?)```", document, re.DOTALL)
    assert len(blocks) == 5
    names: dict[str, Any] = {}
    for block in blocks:
        exec(compile(block, "docs/measured_surface.md", "exec"), names)
    said = capsys.readouterr().out
    assert "Surface of 64 × 48 heights, cells of 4 µm" in said
    assert "21 of 12 288 heights filled in, harmonic" in said
    assert "cut-off λ_c 800 µm" in said
    assert names["result"].converged
    assert 0 < names["result"]["contact_ratio"] < 1
    # The table of the self-affine surface, which is the last that was made.
    job = {**names["job"], "upper": {**names["job"]["upper"], "surface": names["rough"]}}
    contact = brinell.Client().solve(job)
    (row,) = re.findall(r"\n\| 2 \| .*", document)
    assert f" {100 * contact['contact_ratio']:.2f} % " in row
    assert f" {contact['nominal_pressure']:.1f} " in row


def test_the_line_of_the_documents_saves_a_masked_array(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    heights = np.ma.masked_array(bumps(), mask=bumps() > 1e-3)
    document = (ROOT / "docs/measured_surface.md").read_text("utf-8")
    (line,) = re.findall(r"`(numpy\.save\(.*?\))`", document.replace("\n", " "))
    exec(line, {"numpy": np, "heights": heights})
    read = brinell.surface("heights.npy", spacing=1, unit="µm")
    assert read.missing == np.count_nonzero(heights.mask)


def test_masks_in_lists_are_holes() -> None:
    heights = bumps()
    mask = np.zeros(heights.shape, dtype=bool)
    mask[2, 3] = True
    rows = [np.ma.array(row, mask=hidden) for row, hidden in zip(heights, mask, strict=True)]
    tables = [pd.Series(row).mask(hidden) for row, hidden in zip(heights, mask, strict=True)]
    for source in (rows, tables):
        assert np.argwhere(np.isnan(brinell.surface(source, spacing=1).heights)).tolist() == [
            [2, 3]
        ]
    columns = [np.arange(24.0), np.ma.array(heights[:, 0], mask=mask[:, 3])]
    with pytest.raises(
        brinell.InvalidJob, match="1 of 24 heights are missing, the first at point 3"
    ):
        brinell.trace(columns)


@pytest.mark.parametrize(
    ("source", "words"),
    [
        (bumps() + 0j, "not complex128"),
        (bumps() > 0, "not bool"),
        (np.zeros((9, 9), dtype="M8[s]"), "not datetime64"),
        (np.zeros((9, 9), dtype=[("x", "f8"), ("z", "f8")]), "give one of its fields"),
        ([["1,5"] * 9] * 9, "heights/0/0: “1,5” is no number"),
        ([[1.0, 2.0, 3.0]] * 8 + [[1.0, 2.0]], "lines of different lengths"),
    ],
)
def test_what_is_no_figure_is_refused(source: Any, words: str) -> None:
    with pytest.raises(brinell.InvalidJob) as caught:
        brinell.surface(source, spacing=1)
    assert words in str(caught.value)


def test_labels_of_a_table_are_places() -> None:
    heights = bumps()
    x, y = 0.5 * np.arange(24), 0.25 * np.arange(16)
    table = pd.DataFrame(heights, index=x, columns=y)
    for one in (table, table.iloc[::-1], table.iloc[:, ::-1], table.rename(columns=str)):
        made = brinell.surface(one, unit="µm")
        assert made.heights == pytest.approx(1e-3 * heights)
        assert made.spacing == pytest.approx((5e-4, 2.5e-4))
    part = pd.DataFrame(heights).iloc[4:20, 2:]
    assert brinell.surface(part, spacing=1).heights == pytest.approx(heights[4:20, 2:])
    for one, words in (
        (table, "the index of the table has steps of 0.5"),
        (pd.DataFrame(heights).iloc[np.argsort(heights[:, 0])], "do not rise by equal steps"),
    ):
        with pytest.raises(brinell.InvalidJob, match=words):
            brinell.surface(one, spacing=1)
    points = [[heights[i, j], x[i], y[j]] for i in range(24) for j in range(16)]
    made = brinell.surface(pd.DataFrame(points, columns=["z", "x", "y"]))
    assert made.heights == pytest.approx(heights)


def test_units_that_contradict_an_array_of_xarray_are_refused() -> None:
    def array(across: str = "µm", along: str = "µm", **attributes: str) -> Any:
        return xarray.DataArray(
            bumps(),
            dims=("x", "y"),
            coords={
                "x": ("x", 0.5 * np.arange(24), {"units": across}),
                "y": ("y", 0.5 * np.arange(16), {"units": along}),
            },
            attrs={"units": "nm", **attributes},
        )

    for source, given, words in (
        (array(), {"height_unit": "µm"}, "the array says 'nm'"),
        (array(), {"unit": "mm"}, "the array says 'µm'"),
        (array("µm", "mm"), {"unit": "mm"}, "in µm and in mm"),
        (array(positive="down"), {}, "count downward"),
    ):
        with pytest.raises(brinell.InvalidJob, match=words):
            brinell.surface(source, **given)


def waves() -> tuple[Any, Any]:
    """Places [mm] and heights [µm] of a trace."""
    x = 0.005 * np.arange(200)
    return x, np.sin(5 * x) + 0.2 * np.cos(71 * x)


@pytest.mark.parametrize(
    ("head", "given", "words"),
    [
        (["x [mm]\tz [µm]"], {}, None),
        (["X-Einheit [mm]", "Z-Einheit [µm]"], {}, None),
        (["x unit = mm", "z unit = µm"], {}, None),
        (["x\tz", "mm\tµm"], {}, None),
        (["Profile in direction of rolling", "# x(mm) z(um)"], {}, None),
        (["X (mm)\tZ"], {"height_unit": "µm"}, None),
        (["X (mm)\tZ"], {}, "no unit of heights"),
        (["X\tZ [µm]"], {}, "no unit of x"),
        (["x [in]\tz [µin]"], {}, "line 1: “x "),
        (["x [mm]\tz [V]"], {}, "line 1: “x "),
        (["Filter [mm] off", "x [mm]\tz [µm]"], {}, "line 1: “Filter"),
        (["Alle Längen in µm"], {}, "line 1: “Alle"),
        (["x [mm]\tz [µm]", "x unit: m"], {}, "line 2 says “m”"),
        (["x [mm]\tz [µm]"], {"unit": "µm"}, "the file says 'mm'"),
        (["x [mm]\tz [µm]"], {"height_unit": "nm"}, "the file says 'µm'"),
    ],
)
def test_heads_of_traces(
    tmp_path: Path, head: list[str], given: dict[str, Any], words: str | None
) -> None:
    x, z = waves()
    path = tmp_path / "trace.txt"
    lines = [f"{a:.6f}\t{b:.6f}" for a, b in zip(x, z, strict=True)]
    path.write_text("\n".join([*head, *lines]), "utf-8")
    if words is None:
        whole = brinell.trace(np.column_stack([x, 1e-3 * z]))
        assert brinell.trace(path, **given).points == pytest.approx(whole.points, abs=1e-8)
        return
    with pytest.raises(brinell.InvalidJob) as caught:
        brinell.trace(path, **given)
    assert words in str(caught.value)


def test_columns_of_traces_are_not_swapped_in_silence(tmp_path: Path) -> None:
    x, z = waves()
    whole = brinell.trace(np.column_stack([x, z])).points
    for source in (
        pd.DataFrame({"z": z, "x": x}),
        pd.Series(z, index=x),
    ):
        assert brinell.trace(source).points == pytest.approx(whole)
    path = tmp_path / "trace.txt"
    lines = [f"{b:.6f}\t{a:.6f}" for a, b in zip(x, z, strict=True)]
    path.write_text("\n".join(["z [mm]\tx [mm]", *lines]), "utf-8")
    assert brinell.trace(path).points == pytest.approx(whole, abs=1e-5)
    for source, given, words in (
        (np.column_stack([z, x]), {}, "swapped"),
        (np.column_stack([x, z]), {"spacing": 1}, "the first column is x"),
        (pd.Series(z, index=x), {"spacing": 1}, "the index of the table has places"),
        (z, {"spacing": -1}, "positive"),
    ):
        with pytest.raises(brinell.InvalidJob, match=words):
            brinell.trace(source, **given)


@pytest.mark.parametrize("figure", [-9999.0, 1e38, -32768.0, np.inf])
def test_figures_of_traces_that_stand_for_no_data_are_refused(figure: float) -> None:
    x, z = waves()
    z[50] = figure
    with pytest.raises(brinell.InvalidJob, match=r"#/trace/50: 1 of 200 .* at point 51"):
        brinell.trace(np.column_stack([x, z]))
    made = brinell.trace(np.column_stack([x, z]), no_data=[figure], fill="linear")
    assert made.heights.min() > -2.5


def test_a_gap_in_a_trace_is_named() -> None:
    x, z = waves()
    x[100:] += 1
    assert "nothing is measured over 1.005 mm behind point 100" in repr(
        brinell.trace(np.column_stack([x, z]))
    )


def test_a_pitch_that_no_surface_has_is_asked_about(tmp_path: Path) -> None:
    pytest.importorskip("SurfaceTopography")
    # A map of NanoFocus whose pitch is in nanometres: its reader takes 312.5 for millimetres.
    head = bytearray(3468)
    struct.pack_into("<2d", head, 16, 2.7, 6.0)
    struct.pack_into("<2I2d", head, 1368, 16, 16, 312.5, 312.5)
    i, j = np.meshgrid(np.arange(16), np.arange(16), indexing="ij")
    heights = (30000 + 9000 * np.sin(i / 3) * np.cos(j / 4)).astype("<u2").tobytes()
    (tmp_path / "map.nms").write_bytes(bytes(head) + heights)
    with pytest.raises(brinell.InvalidJob, match=r"every 312\.5 mm .* a unit is wrong"):
        brinell.surface(tmp_path / "map.nms")


def test_a_decimal_comma_names_what_takes_it() -> None:
    with pytest.raises(brinell.InvalidJob, match='decimal=","'):
        brinell.surface([["1,5"] * 9] * 9, spacing=1)


@pytest.mark.parametrize(("text", "size"), [("1 2 3 4", "1 × 4"), ("1\n2\n3\n4", "4 × 1")])
def test_a_line_of_heights_is_no_grid(tmp_path: Path, text: str, size: str) -> None:
    (tmp_path / "line.txt").write_text(text)
    with pytest.raises(brinell.InvalidJob, match=f"{size} figures are no grid"):
        brinell.surface(tmp_path / "line.txt", spacing=1)
