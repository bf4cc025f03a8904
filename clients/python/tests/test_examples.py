"""The notebooks run from their first to their last line."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT

EXAMPLES = ROOT / "clients/python/examples"
DOCUMENT = ROOT / "docs/many_jobs.md"
FIGURES = {"first_contact": 3, "sweep": 2, "dent": 4, "fit": 1, "hardness": 1}


def test_every_notebook_is_run() -> None:
    assert {path.stem for path in EXAMPLES.glob("*.py")} == set(FIGURES)


@pytest.mark.full
@pytest.mark.parametrize("name", FIGURES)
def test_a_notebook(name: str, tmp_path: Path) -> None:
    script = ROOT / "clients/python/scripts/run_example.py"
    subprocess.run(
        [sys.executable, script, EXAMPLES / f"{name}.py", tmp_path], check=True, timeout=300
    )
    figures = sorted(tmp_path.glob("*.png"))
    assert len(figures) == FIGURES[name]
    assert {path.name for path in figures} == {
        path.name for path in (EXAMPLES / "figures").glob(f"{name}-*.png")
    }


@pytest.mark.full
def test_the_document_on_many_jobs(tmp_path: Path) -> None:
    subprocess.run(
        [sys.executable, ROOT / "clients/python/scripts/run_readme.py", DOCUMENT],
        check=True,
        timeout=300,
        cwd=tmp_path,
    )
