"""The input that a job asks for, and what tolerances do, as pandas tables."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from ._errors import BrinellError
from ._plain import need

if TYPE_CHECKING:
    import pandas as pd


def found_of(report: Mapping[str, Any]) -> pd.DataFrame:
    """The jobs of a search: `value` of the input, `figure` and its relative `error`.

    `attrs` has `vary`, the name of the `figure`, the `values` with which it is as wanted, that of
    this result first, and `text`.
    """
    found = report.get("found")
    if not found:
        raise BrinellError("the job asks for no input: it has no `find`")
    frame: pd.DataFrame = need("pandas", "pandas").DataFrame(found["looks"])
    frame.attrs.update({key: found[key] for key in ("vary", "figure", "values", "text")})
    return frame


def tolerances_of(report: Mapping[str, Any]) -> pd.DataFrame:
    """What tolerances do to each row of the result: its `name`, `label` and `body`, its `error` by
    the mesh, its relative changes `root_of_squares` and `at_worst`, and its elasticity for each
    input, whose pointer names the column. `attrs` has the `tolerances` and `text`.
    """
    told = report.get("tolerances")
    if not told:
        raise BrinellError("the job has no `tolerances`")
    kept = ("name", "label", "body", "error", "root_of_squares", "at_worst")
    frame: pd.DataFrame = need("pandas", "pandas").DataFrame({key: told[key] for key in kept})
    for k, pointer in enumerate(told["inputs"]):
        frame[pointer] = [row[k] for row in told["elasticities"]]
    frame.attrs["tolerances"] = dict(zip(told["inputs"], told["relative"], strict=True))
    frame.attrs["text"] = told["text"]
    return frame
