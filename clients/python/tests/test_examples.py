"""Notebooks and documents run from their first to their last line."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT

EXAMPLES = ROOT / "clients/python/examples"
SCRIPTS = ROOT / "clients/python/scripts"
FIGURES = {"first_contact": 3, "sweep": 2, "dent": 4, "fit": 1, "hardness": 1}
OF_TUTORIAL = ROOT / "docs/figures/tutorial"


def run(script: str, *arguments: Path, cwd: Path) -> None:
    command = [sys.executable, SCRIPTS / script, *arguments]
    subprocess.run(command, check=True, timeout=300, cwd=cwd)


def test_every_notebook_is_run_and_has_no_outputs() -> None:
    assert {path.stem for path in EXAMPLES.glob("*.ipynb")} == set(FIGURES)
    for path in EXAMPLES.glob("*.ipynb"):
        cells = json.loads(path.read_text("utf-8"))["cells"]
        assert not any(cell.get("outputs") or cell.get("execution_count") for cell in cells), path


@pytest.mark.full
@pytest.mark.parametrize("name", FIGURES)
def test_a_notebook(name: str, tmp_path: Path) -> None:
    run("run_notebook.py", EXAMPLES / f"{name}.ipynb", tmp_path, cwd=tmp_path)
    figures = sorted(tmp_path.glob("*.png"))
    assert len(figures) == FIGURES[name]
    assert {path.name for path in figures} == {
        path.name for path in (EXAMPLES / "figures").glob(f"{name}-*.png")
    }


@pytest.mark.full
def test_the_document_on_many_jobs(tmp_path: Path) -> None:
    run("run_readme.py", ROOT / "docs/many_jobs.md", cwd=tmp_path)


@pytest.mark.full
def test_the_tutorial(tmp_path: Path) -> None:
    """With BRINELL_WRITE=1 it writes its figures and what it prints."""
    folder = OF_TUTORIAL if os.environ.get("BRINELL_WRITE") else tmp_path
    run("run_readme.py", ROOT / "docs/tutorial.md", cwd=folder)
    assert {path.name for path in folder.glob("*.png")} == {
        path.name for path in OF_TUTORIAL.glob("*.png")
    }
