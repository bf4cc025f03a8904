"""What is generated or copied is current."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT

import brinell
from brinell._plain import _KINDS

pytestmark = pytest.mark.generated

PACKAGE = ROOT / "clients/python/brinell/src/brinell"
SCRIPTS = ROOT / "clients/python/scripts"


def test_models_are_those_of_the_document(tmp_path: Path) -> None:
    subprocess.run([SCRIPTS / "models.sh", sys.executable, tmp_path], check=True)
    for name in ("models.py", "reports.py"):
        made = (tmp_path / name).read_text("utf-8")
        assert made == (PACKAGE / name).read_text("utf-8"), "run scripts/models.sh"


def test_builders_are_those_of_the_document(tmp_path: Path) -> None:
    made = tmp_path / "builders.py"
    subprocess.run([sys.executable, SCRIPTS / "builders.py", made], check=True)
    assert made.read_text("utf-8") == (PACKAGE / "_builders.py").read_text("utf-8"), (
        "run scripts/builders.py"
    )


def test_builders_are_exported() -> None:
    from brinell import _builders

    assert set(_builders.__all__) <= set(brinell.__all__)


@pytest.mark.parametrize("name", ["materials.json", "columns.json"])
def test_data_are_those_of_the_interface(name: str) -> None:
    assert (PACKAGE / name).read_bytes() == (ROOT / "api" / name).read_bytes()


def test_every_figure_with_a_unit_has_its_kind() -> None:
    schemas = json.loads((ROOT / "api/openapi.json").read_text("utf-8"))["components"]["schemas"]
    kinds = {" N mm ": "moment", " mm ": "length", " MPa ": "stress", " N/mm ": "force"}
    seen = 0
    for schema in schemas.values():
        if schema.get("additionalProperties") is not False:
            continue
        for name, member in schema["properties"].items():
            text = member.get("description", "") + member.get("items", {}).get("description", "")
            found = [kind for unit, kind in kinds.items() if "Range:" in text and unit in text]
            # N mm has mm in it.
            for kind in found[:1]:
                assert _KINDS.get(name) == kind, f"{name}: {text}"
                seen += 1
    assert seen > 30
