"""Writes the files of docs/measured_surface.md: a map of heights in three formats and a trace."""

from pathlib import Path

import numpy as np
from SurfaceTopography import Topography
from SurfaceTopography.IO.NC import write_nc_uniform
from SurfaceTopography.IO.X3P import write_x3p

rng = np.random.default_rng(7)
kx, ky = np.fft.fftfreq(128)[:, None], np.fft.rfftfreq(96)[None, :]
k = np.hypot(kx, ky)
waves = np.where(k > 0, np.maximum(k, 0.02), np.inf) ** -1.8 * (k < 0.08)
noise = rng.normal(size=k.shape) + 1j * rng.normal(size=k.shape)
heights = np.fft.irfft2(waves * noise, (128, 96))
heights *= 0.2e-6 / heights.std()
heights += 1e-9 * np.arange(128)[:, None]
mask = np.zeros(heights.shape, bool)
mask[40:44, 50:55] = mask[90, 10] = True
step = 2e-6
masked = np.ma.masked_array(heights, mask=mask)
measured = Topography(masked, (128 * step, 96 * step), unit="m")
write_x3p(measured, "scan.x3p")
write_nc_uniform(measured, "scan.nc")
rows = [
    "\t".join("nan" if hole else f"{z:.9e}" for z, hole in zip(line, holes, strict=True))
    for line, holes in zip(heights.T[::-1], mask.T[::-1], strict=True)
]
head = ["# Channel: Z", "# Width: 256.0 µm", "# Height: 192.0 µm", "# Value units: m"]
Path("scan.txt").write_text("\n".join([*head, *rows]), "utf-8")
x = 1e-3 * np.arange(4000)
trace = [f"{a:.3f}, {b:.6f}" for a, b in zip(x, np.cos(x) + rng.normal(size=4000), strict=True)]
Path("trace.csv").write_text("x [mm], z [µm]\n" + "\n".join(trace), "utf-8")
