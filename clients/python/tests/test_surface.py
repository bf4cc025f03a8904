"""Measured surfaces: files as instruments write them, holes, units, thinning."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pint
import pytest
import xarray
from conftest import ROOT

import brinell
from brinell._grid_text import NotUnderstood, read_grid
from brinell._plain import document_of
from brinell._surface import _text_of

CASES = json.loads((ROOT / "tests/measured/grids.json").read_text("utf-8"))


@pytest.mark.parametrize("case", CASES, ids=[case["name"] for case in CASES])
def test_a_text_is_understood_or_refused(case: dict[str, Any]) -> None:
    text = _text_of(case["text"].encode(case["encoding"]))
    assert text is not None
    if "refused" in case:
        with pytest.raises(NotUnderstood, match=".") as caught:
            read_grid(text)
        assert case["refused"] in str(caught.value)
        if "line" in case:
            read_grid(text, (case["line"],))
        return
    grid = read_grid(text)
    assert list(grid.heights.shape) == case["shape"]
    assert (grid.across, grid.up) == (case["across"], case["up"])
    if case["spacing"] is None:
        assert grid.spacing is None
    else:
        assert grid.spacing == pytest.approx(case["spacing"])
    assert np.count_nonzero(np.isnan(grid.heights)) == case["missing"]
    if "corners" in case:
        ends = grid.heights[[0, 0, -1, -1], [0, -1, 0, -1]]
        assert ends == pytest.approx(case["corners"])
    assert case.get("says", "") in "; ".join(grid.notes)
