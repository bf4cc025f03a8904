"""A rigid ball on an elasto-plastic half-space by Tamaas, for comparison with Brinell on cells of
the same size.

    python3 -m venv tamaas && tamaas/bin/pip install tamaas scipy numpy
    tamaas/bin/python -W ignore tools/tamaas_ball.py 16 3.2

Takes cells over a side, and the length of the periodic box over the half-width of the contact.
Radius 10 mm, E = 210 GPa, nu = 0.3, yield stress 500 MPa, tangent modulus 0.05 E. Hertz's peak
pressure is four yield stresses. One step, on one thread. `cargo bench --bench three_dimensions`
has the same ball as `deformation`.
"""

import os
import sys
import time

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np
import tamaas as tm
from tamaas.nonlinear_solvers import DFSANESolver

YOUNG, POISSON, YIELD, RADIUS = 210e3, 0.3, 500.0, 10.0
TANGENT = 0.05 * YOUNG
FORCE = 77.63053
# Half-width of the contact over Hertz's.
WIDENING = 1.17


def main(n, period):
    tm.initialize(1)
    modulus = YOUNG / (1 - POISSON**2)
    a0 = (3 * FORCE * RADIUS / (4 * modulus)) ** (1 / 3)
    length = period * WIDENING * a0
    depth = 2.6 * WIDENING * a0
    layers = max(2, round(depth / (length / n)) + 1)
    print(f"a0 {a0:.6f} mm, cell/a0 {length / n / a0:.4f}, layers {layers}")
    model = tm.ModelFactory.createModel(
        tm.model_type.volume_2d, [depth, length, length], [layers, n, n]
    )
    model.E, model.nu = YOUNG, POISSON
    hardening = TANGENT / (1 - TANGENT / YOUNG)
    residual = tm.ModelFactory.createResidual(model, sigma_y=YIELD, hardening=hardening)
    x = (np.arange(n) - n / 2 + 0.5) * length / n
    surface = -(x[:, None] ** 2 + x[None, :] ** 2) / (2 * RADIUS)
    surface -= surface.max()
    by_pressure = tm.PolonskyKeerRey.pressure
    contact = tm.PolonskyKeerRey(model, surface, 1e-10, by_pressure, by_pressure)
    plastic = DFSANESolver(residual)
    plastic.tolerance = 1e-7
    epic = tm.EPICSolver(contact, plastic, 1e-4)
    start = time.perf_counter()
    epic.acceleratedSolve(FORCE / length**2)
    seconds = time.perf_counter() - start
    pressure = model.traction[..., 2]
    print(
        f"{seconds:.2f} s, peak {pressure.max():.1f} MPa, force {pressure.sum() * (length / n) ** 2:.4f} N"
    )


if __name__ == "__main__":
    main(int(sys.argv[1]), float(sys.argv[2]))
