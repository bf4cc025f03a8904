#!/usr/bin/env python3
"""HBW over HV of a family of curves, beside ISO 18265, as a table and as a picture.

    BRINELL_PROGRAM=target/debug/brinell PYTHONPATH=clients/python/brinell/src \\
        python tools/hardness_scales.py docs/figures/hardness_scales.svg

Swift's law with n of 0.08 and 0.2, E of 210 GPa, HBW 10/3000 and HV 10 with 16 elements.
"""

from __future__ import annotations

import sys

import matplotlib as mpl
import matplotlib.pyplot as plt

import brinell

# ISO 18265, table A.1, unalloyed and low-alloy steels: HV and HBW.
STANDARD = [(200, 190), (300, 285), (400, 380), (500, 475)]
FAMILY = {0.08: [400, 600, 800, 1000, 1200, 1400], 0.2: [200, 300, 400, 500, 650, 800]}


def steel(yield_stress: float, exponent: float) -> object:
    law = brinell.swift(
        yield_stress=yield_stress,
        strain_offset=yield_stress / 210_000,
        exponent=exponent,
    )
    return brinell.material(young_modulus=210_000, poisson_ratio=0.3, plasticity=law)


def main(where: str) -> None:
    jobs, keys = [], []
    for exponent, strengths in FAMILY.items():
        for strength in strengths:
            one = steel(strength, exponent)
            jobs.append(brinell.brinell_test(one, elements_per_half_width=16))
            jobs.append(brinell.vickers(one, force_kgf=10, elements_per_half_width=16))
            keys.append((exponent, strength))
    with brinell.Client() as client:
        found = [result.row("hardness") for _, result in client.map(jobs, ordered=True)]
    mpl.rcParams["svg.hashsalt"] = "brinell"
    _, ax = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
    print("| n | σ_y [MPa] | HBW 10/3000 | HV 10 | HBW / HV |\n|--:|--:|--:|--:|--:|")
    for exponent, marker in zip(FAMILY, "os", strict=True):
        points = []
        for at, key in enumerate(keys):
            if key[0] != exponent:
                continue
            ball, pyramid = found[2 * at], found[2 * at + 1]
            texts = [
                f"{one.value:.0f} ± {100 * one.error:.1f} %" if one.error > 0 else "none"
                for one in (ball, pyramid)
            ]
            ratio = (
                "" if "none" in texts else f"{ball.value / pyramid.value:.3f}"
            )
            print(f"| {exponent} | {key[1]} | {texts[0]} | {texts[1]} | {ratio} |")
            if ratio:
                points.append(
                    [
                        pyramid.value,
                        ball.value,
                        *(one.value * one.error for one in (pyramid, ball)),
                    ]
                )
        x, y, dx, dy = zip(*points, strict=True)
        ax.errorbar(
            x,
            y,
            yerr=dy,
            xerr=dx,
            fmt=marker,
            capsize=2,
            elinewidth=0.8,
            label=f"n = {exponent}",
        )
    ax.plot(*zip(*STANDARD, strict=True), "k.-", label="ISO 18265, table A.1")
    ax.set(xlabel="HV 10", ylabel="HBW 10/3000")
    ax.legend(frameon=False)
    plt.savefig(where, metadata={"Date": None})


main(sys.argv[1])
