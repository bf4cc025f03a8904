from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import matplotlib
import pytest

import brinell

matplotlib.use("Agg")

ROOT = Path(__file__).resolve().parents[3]
EXAMPLES = ROOT / "api/examples"


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "full: takes its time")
    config.addinivalue_line("markers", "generated: needs the generators")
    if "BRINELL_PROGRAM" not in os.environ:
        raise pytest.UsageError("BRINELL_PROGRAM is the program to test against")


@pytest.fixture(scope="session")
def client() -> Iterator[brinell.Client]:
    with brinell.Client() as client:
        yield client


def roller(yield_stress: float = 500.0) -> Any:
    law = brinell.bilinear(yield_stress=yield_stress, tangent_modulus=10500)
    steel = brinell.material(young_modulus=210000, poisson_ratio=0.3, plasticity=law)
    return brinell.cylinder(radius=20, material=steel)


@pytest.fixture
def job() -> Any:
    """The reference problem."""
    return brinell.job(roller(), roller(), analysis="plane_strain", force=612.6106)


@pytest.fixture(scope="session")
def dent(client: brinell.Client) -> brinell.Result:
    """A load by flow theory, and without it, with fields."""
    loads = [{"force": 612.6106}, {"force": 0}]
    return client.solve(
        brinell.job(
            roller(),
            roller(),
            analysis="plane_strain",
            history=loads,
            theory="flow",
            elements_per_half_width=8,
            fields=True,
        )
    )
