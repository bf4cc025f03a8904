"""An elastic rough patch beside other programs: ContactMechanics without periods, and Tamaas.

    python3 -m venv other && other/bin/pip install ContactMechanics tamaas numpy
    cargo build --release -p brinell-halfspace --example rough_patch
    other/bin/python -W ignore tools/rough_patch.py 512 target/release/examples/rough_patch

Takes cells along a side and the example. Heights are self-affine with a Hurst exponent of 0.8
and a root mean square slope of 0.1; their waves are between an eighth of the side and 8 cells.
The side is 1, E* is 1. All on one thread. Prints area over nominal area, largest pressure,
approach from the highest point, and what the others differ by. `waves` in place of a number
writes the reference of `crates/brinell-halfspace/tests/waves.rs`.
"""

import os
import subprocess
import sys
import tempfile
import time

os.environ.setdefault("OMP_NUM_THREADS", "1")

import numpy as np


def self_affine(n, seed=1):
    """Heights of n x n points, root mean square slope 0.1."""
    q = 2 * np.pi * np.fft.fftfreq(n, 1 / n)
    qx, qy = np.meshgrid(q, q, indexing="ij")
    size = np.hypot(qx, qy)
    kept = (size >= 2 * np.pi * 8) & (size <= 2 * np.pi * n / 8)
    amplitude = np.where(kept, np.maximum(size, 1) ** -1.8, 0)
    noise = np.fft.fft2(np.random.default_rng(seed).standard_normal((n, n)))
    spectrum = amplitude * noise
    slope = np.sqrt((np.abs(size * spectrum) ** 2).sum()) / n**2
    return 0.1 / slope * np.fft.ifft2(spectrum).real


def waves(n):
    """The heights of the Rust test: waves of 1 to 8 over the side, amplitudes k^-1.8."""
    state = 7
    x = (np.arange(n) - 0.5 * (n - 1)) / n
    heights = np.zeros((n, n))
    for kx in range(-8, 9):
        for ky in range(9):
            size = np.hypot(kx, ky)
            if 1 <= size <= 8 and (ky > 0 or kx > 0):
                state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
                phase = 2 * np.pi * (state >> 33) / 2**31
                argument = 2 * np.pi * (kx * x[:, None] + ky * x[None, :]) + phase
                heights += 1e-3 * size**-1.8 * np.cos(argument)
    return heights


def brinell(program, heights, force, tolerance):
    """Pressures and the lines that the example prints."""
    n = len(heights)
    with tempfile.TemporaryDirectory() as folder:
        source, result = os.path.join(folder, "heights"), os.path.join(folder, "pressures")
        heights.astype("<f8").tofile(source)
        command = [program, source, str(n), repr(force), str(tolerance), result]
        done = subprocess.run(command, check=True, capture_output=True, text=True)
        return np.fromfile(result, "<f8").reshape(n, n), done.stdout.strip()


def contact_mechanics(heights, force, tolerance):
    """Pressures, approach from the highest point, seconds."""
    from ContactMechanics import FreeFFTElasticHalfSpace
    from ContactMechanics.Systems import NonSmoothContactSystem
    from SurfaceTopography import Topography

    n = len(heights)
    substrate = FreeFFTElasticHalfSpace((n, n), 1.0, (1.0, 1.0))
    system = NonSmoothContactSystem(substrate, Topography(heights, (1.0, 1.0)))
    start = time.perf_counter()
    # Tolerances are of gaps and forces, absolute.
    system.minimize_proxy(
        external_force=force, pentol=tolerance * force, forcetol=tolerance * force / n**2
    )
    seconds = time.perf_counter() - start
    pressure = np.asarray(system.substrate.force)[:n, :n] * n**2
    # The offset is that of the surface towards the body.
    pressure = -pressure if pressure.sum() < 0 else pressure
    return pressure, system.offset + heights.max(), seconds


def tamaas_solve(heights, force, tolerance):
    """The same in a box of twice the side, whose other three quarters are out of reach."""
    import tamaas as tm

    tm.initialize(1)
    n = len(heights)
    model = tm.ModelFactory.createModel(tm.model_type.basic_2d, [2.0, 2.0], [2 * n, 2 * n])
    model.E, model.nu = 1.0, 0.0
    surface = np.full((2 * n, 2 * n), heights.min() - 10.0)
    surface[:n, :n] = heights
    solver = tm.PolonskyKeerRey(model, surface, tolerance)
    start = time.perf_counter()
    solver.solve(force / 4.0)
    return np.array(model.traction)[:n, :n], time.perf_counter() - start


def compare(name, mine, theirs):
    areas = [(p > 0).mean() for p in (mine, theirs)]
    worst = np.abs(mine - theirs).max() / mine.max()
    print(
        f"{name}: area {areas[1]:.6f} ({areas[1] / areas[0] - 1:+.1e}), largest pressure "
        f"{theirs.max():.8f} ({theirs.max() / mine.max() - 1:+.1e}), pressures differ by "
        f"{worst:.1e} of the largest"
    )


def main(size, program):
    tolerance = 1e-8
    heights = waves(128) if size == "waves" else self_affine(int(size))
    for mean in [2e-4, 1e-3] if size == "waves" else [0.0025, 0.01]:
        mine, said = brinell(program, heights, mean, tolerance)
        print(f"mean pressure {mean}: {said}")
        theirs, approach, seconds = contact_mechanics(heights, mean, tolerance)
        compare("ContactMechanics", mine, theirs)
        print(f"  approach {approach:.8e}, {seconds:.1f} s, cells {(theirs > 0).sum()}")
        if size == "waves":
            continue
        theirs, seconds = tamaas_solve(heights, mean, 1e-10)
        compare("Tamaas, periodic, twice the side", mine, theirs)
        print(f"  {seconds:.1f} s")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
