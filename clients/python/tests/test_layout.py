"""Imports run one way: no module of the package imports, over others, from one that imports it.

Imports inside functions and those of types alone count.
"""

from __future__ import annotations

import ast
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

import brinell

PACKAGE = Path(brinell.__file__).parent


def imported(source: str, modules: set[str]) -> set[str]:
    """The modules beside it that a module imports from."""
    names = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.ImportFrom) and node.level == 1:
            names |= {node.module} if node.module else {alias.name for alias in node.names}
    return names & modules


def in_order(sources: dict[str, str]) -> list[str]:
    """The modules, each after those that it imports from."""
    graph = {name: imported(source, set(sources)) for name, source in sources.items()}
    return list(TopologicalSorter(graph).static_order())


def test_no_modules_import_each_other() -> None:
    sources = {path.stem: path.read_text() for path in PACKAGE.glob("*.py")}
    order = in_order(sources)
    assert len(order) > 20
    assert order.index("_rows") < order.index("_data") < order.index("_result")


def test_a_circle_over_an_import_of_types_is_found() -> None:
    above = "def pictures():\n    from ._plot import Plot\n"
    below = "if TYPE_CHECKING:\n    from . import _result\n"
    with pytest.raises(CycleError):
        in_order({"_result": above, "_plot": below})
