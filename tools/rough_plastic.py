"""Rough patches that yield: whether they converge, and at what cost.

    cargo build --release
    python3 tools/rough_plastic.py target/release/brinell 256 3

Takes the program, cells along a side and seeds. A rigid rough body is pressed on steel with a yield
stress of 1000 MPa and a tangent modulus of 10 GPa under three forces that bring some 1, 5 and 20 %
of the area into contact. Heights are self-affine with a Hurst exponent of 0.8 and a root mean
square slope of 0.05; their waves are between a quarter of the side and 8 cells of 4 µm. One line
for each load. A fourth word is the theory, `deformation` or `flow`.
"""

import json
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np

SPACING = 4e-3
# Mean pressures [MPa].
PRESSURES = [25.0, 125.0, 500.0]


def heights(n, seed):
    """Heights of n x n points [mm]."""
    q = 2 * np.pi * np.fft.fftfreq(n, SPACING)
    size = np.hypot(q[:, None], q[None, :])
    longest, shortest = 2 * np.pi / (n * SPACING / 4), 2 * np.pi / (8 * SPACING)
    kept = (size >= longest) & (size <= shortest)
    noise = np.fft.fft2(np.random.default_rng(seed).standard_normal((n, n)))
    spectrum = np.where(kept, np.maximum(size, longest) ** -1.8, 0) * noise
    slope = np.sqrt((np.abs(size * spectrum) ** 2).sum()) / n**2
    return 0.05 / slope * np.fft.ifft2(spectrum).real


def job(n, seed, theory, loads):
    surface = {"heights": heights(n, seed).tolist(), "spacing_x": SPACING, "spacing_y": SPACING}
    law = {"law": "bilinear", "yield_stress": 1000, "tangent_modulus": 10000}
    steel = {"young_modulus": 210000, "poisson_ratio": 0.3, "plasticity": law}
    rigid = {"shape": {"type": "flat"}, "material": {"rigid": True}, "surface": surface}
    return {
        "analysis": "three_dimensional",
        "load": loads,
        "upper": rigid,
        "lower": {"shape": {"type": "flat"}, "material": steel},
        "solver": {"theory": theory},
        "output": {"subsurface": False},
    }


def solve(program, n, seed, theory, loads):
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump(job(n, seed, theory, loads), file)
        file.flush()
        start = time.perf_counter()
        done = subprocess.run([program, "solve", file.name], capture_output=True, text=True)
        seconds = time.perf_counter() - start
    if not done.stdout:
        raise SystemExit(done.stderr)
    memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    return json.loads(done.stdout), seconds, memory


def main(program, n, seeds, theory="deformation"):
    n = int(n)
    area = (n * SPACING) ** 2
    print("seed status evaluations area yields peak ± approach ± strain ± seconds MB")
    for seed in range(int(seeds)):
        for pressure in PRESSURES:
            result, seconds, memory = solve(
                program, n, seed, theory, {"force": pressure * area}
            )
            for step in result["steps"]:
                # A figure is of the contact, or of the one body that yields.
                rows = {row["name"]: row for row in step["answers"]}
                value = lambda name: rows[name]["value"] if name in rows else 0.0

                def bar(name):
                    error = rows.get(name, {}).get("error")
                    return f"{100 * error:.1f}%" if isinstance(error, float) else "-"

                print(
                    seed,
                    step["status"],
                    len(step["history"]),
                    f"{100 * value('contact_ratio'):.2f}%",
                    f"{100 * value('yielded_part'):.0f}%",
                    f"{value('peak_pressure'):.0f}",
                    bar("peak_pressure"),
                    f"{1e3 * value('approach'):.4f}",
                    bar("approach"),
                    f"{100 * value('max_plastic_strain'):.2f}%",
                    bar("max_plastic_strain"),
                    f"{seconds:.1f}",
                    f"{memory:.0f}",
                    flush=True,
                )


if __name__ == "__main__":
    main(*sys.argv[1:])
