#!/usr/bin/env python3
"""Has `brinell solve --format vtu` write fields and reads them back with meshio, and those of `--format vtr` with VTK's own
reader, which is ParaView's.

usage: tests/vtu/read_back.py [path to brinell]
Needs tests/vtu/requirements.txt. Ends with 1 at the first thing that is not as it must be.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import meshio
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLRectilinearGridReader

ROOT = Path(__file__).resolve().parents[2]
BINARY = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "target/debug/brinell")


def solve(job, folder, name):
    """The report of a job and its fields as meshio reads them."""
    text = json.dumps(job)
    path = Path(folder) / name
    for more in (["--format", "json", "-o", f"{path}.json"], ["--format", "vtu", "-o", str(path)]):
        subprocess.run([BINARY, "solve", "-", *more], input=text, text=True, check=True)
    return json.loads(Path(f"{path}.json").read_text()), meshio.read(path)


def solve_layers(job, folder):
    """The step of a job in three dimensions, and its layers as VTK reads them: faces of the cells, and cells by [z, y, x]."""
    job["output"] = {"fields": True}
    text = json.dumps(job)
    path = Path(folder) / "layers.vtr"
    for more in (["--format", "json", "-o", f"{path}.json"], ["--format", "vtr", "-o", str(path)]):
        subprocess.run([BINARY, "solve", "-", *more], input=text, text=True, check=True)
    reader = vtkXMLRectilinearGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    assert reader.GetErrorCode() == 0
    faces = [
        vtk_to_numpy(along)
        for along in (grid.GetXCoordinates(), grid.GetYCoordinates(), grid.GetZCoordinates())
    ]
    shape = [len(along) - 1 for along in reversed(faces)]
    data = grid.GetCellData()
    cells = {}
    for k in range(data.GetNumberOfArrays()):
        array = vtk_to_numpy(data.GetArray(k))
        cells[data.GetArrayName(k)] = array.reshape(*shape, *array.shape[1:])
    return json.loads(Path(f"{path}.json").read_text())["steps"][-1], faces, cells


def areas(grid):
    corners = grid.points[grid.cells_dict["quad"]]
    following = np.roll(corners, -1, axis=1)
    cross = corners[..., 0] * following[..., 1] - following[..., 0] * corners[..., 1]
    return 0.5 * cross.sum(axis=1)


def check_shapes(grid):
    n, m = len(grid.points), len(grid.cells_dict["quad"])
    shapes = {name: values.shape for name, values in grid.point_data.items()}
    assert shapes == {
        "displacement": (n, 3),
        "stress": (n, 6),
        "von_mises": (n,),
        "equivalent_plastic_strain": (n,),
    }, shapes
    (body,) = grid.cell_data["body"]
    assert body.shape == (m,) and set(body) <= {0, 1}
    assert all(np.isfinite(values).all() for values in grid.point_data.values())
    assert (areas(grid) > 0).all(), "a cell is turned inside out"
    return body


def figure(step, name):
    """The value of the first row of a name."""
    return next(row["value"] for row in step["answers"] if row["name"] == name)


def check_cylinders(report, grid):
    body = check_shapes(grid)
    step = report["steps"][0]
    total = [areas(grid)[body == k].sum() for k in (0, 1)]
    assert np.allclose(total, 200 * np.pi, rtol=0.02), total
    x, y, _ = grid.points.T
    at_origin = np.flatnonzero((np.abs(x) < 1e-12) & (np.abs(y) < 1e-12))
    assert len(at_origin) == 2, "one node of each body where they touch, the axis not doubled"
    stress = grid.point_data["stress"]
    xx, yy, zz, xy, yz, xz = stress.T
    assert np.allclose(-yy[at_origin], figure(step, "peak_pressure"), rtol=0.03)
    assert not yz.any() and not xz.any()
    deviator = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    assert np.allclose(
        grid.point_data["von_mises"], np.sqrt(0.5 * deviator + 3 * xy**2), rtol=1e-9
    )
    _, u_y, _ = grid.point_data["displacement"].T
    assert np.allclose(u_y[y > 20 - 1e-9], -figure(step, "approach")) and np.allclose(
        u_y[y < -20 + 1e-9], 0
    )
    strain = grid.point_data["equivalent_plastic_strain"]
    largest = figure(step, "max_plastic_strain")
    assert 0.8 * largest < strain.max() < 1.1 * largest, (strain.max(), largest)


def check_revolution(report, grid):
    check_shapes(grid)
    assert grid.points[:, 0].min() == 0, "x is the radius"


STRESSES = ["xx", "yy", "zz", "xy", "yz", "xz"]


def check_layers(step, faces, cells, bodies):
    """Every number of the file is the one of the report; in the upper body z and both shears with it change their sign."""
    depths = np.array(step["layers"]["lower"]["z_faces"])
    above = -depths[:0:-1] if bodies == 2 else []
    assert np.array_equal(faces[2], np.concatenate([above, depths])), faces[2]
    for axis, along in zip("xy", faces):
        assert np.allclose(
            0.5 * (along[1:] + along[:-1]), step["layers"]["lower"][axis], rtol=1e-12, atol=1e-12
        )
    layers = len(depths) - 1
    assert list(cells["body"][:, 0, 0]) == [1] * (layers * (bodies - 1)) + [0] * layers
    for name in ("upper", "lower")[2 - bodies :]:
        body = step["layers"][name]
        shape = [len(body[axis]) for axis in "zxy"]
        # The report has y fastest, VTK has x fastest.
        array = lambda key: np.array(body[key]).reshape(shape).swapaxes(1, 2)
        sign = [1, 1, 1, 1, -1, -1] if name == "upper" else [1] * 6
        of_body = lambda values: values[:layers][::-1] if name == "upper" else values[-layers:]
        for prefix, file in (("sigma", "stress"), ("plastic_strain", "plastic_strain")):
            found = of_body(cells[file])
            for k, key in enumerate(STRESSES):
                assert np.array_equal(sign[k] * found[..., k], array(f"{prefix}_{key}")), (
                    name,
                    file,
                    key,
                )
        for key in ("von_mises", "equivalent_plastic_strain"):
            assert np.array_equal(of_body(cells[key]), array(key)), (name, key)
    largest = figure(step, "max_plastic_strain")
    assert cells["equivalent_plastic_strain"].max() == largest > 0


def main():
    job = json.loads((ROOT / "api/examples/two_cylinders.json").read_text())
    with tempfile.TemporaryDirectory() as folder:
        check_cylinders(*solve(job, folder, "cylinders.vtu"))
        job["analysis"], job["load"] = "axisymmetric", {"force": 500.0}
        check_revolution(*solve(job, folder, "revolution.vtu"))
        dent = json.loads((ROOT / "api/examples/ellipse_dent.json").read_text())
        dent["mesh"] = {"elements_per_half_width": 5}
        check_layers(*solve_layers(dent, folder), bodies=1)
        ball = dent["lower"]["material"]
        dent["upper"]["material"] = {
            **ball,
            "plasticity": {**ball["plasticity"], "yield_stress": 600.0},
        }
        check_layers(*solve_layers(dent, folder), bodies=2)
    print("field.vtu is read by meshio", meshio.__version__, "and field.vtr by VTK")


main()
