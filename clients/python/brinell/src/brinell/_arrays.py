"""Figures of arrays and tables with their holes: what is masked or missing is no number here."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import numpy.typing as npt

from ._errors import Fault, InvalidJob

Floats = npt.NDArray[np.float64]

DECIMAL_COMMA = 'pandas.read_csv(..., decimal=",") takes a decimal comma'
"""What reads figures with a decimal comma, for refusals."""

# Scalars of pandas that stand for a missing value.
_MISSING = ("NAType", "NaTType")


def without_mask(value: Any) -> Any:
    """The same with NaN where an array is masked or a table has no value.

    Takes numpy's masked arrays and what pandas, xarray and polars keep figures in; anything else
    is given back as it is.
    """
    if isinstance(value, np.ma.MaskedArray):
        return np.ma.filled(value.astype(float), np.nan)
    if type(value).__name__ in _MISSING:
        return float("nan")
    if not hasattr(value, "to_numpy"):
        return value
    try:
        return value.to_numpy(dtype=float, na_value=np.nan)
    except TypeError:
        return without_mask(value.to_numpy())
    except ValueError:
        return value.to_numpy()


def grid_of(value: Any) -> Floats:
    """Heights `[i, j]` at the i-th x and the j-th y, NaN where there is none.

    The dimensions of an array of xarray go by their names: `("y", "x")` is turned.
    """
    dims = getattr(value, "dims", None)
    if isinstance(dims, tuple) and len(dims) == 2:
        names = [str(one).lower() for one in dims]
        if names in (["y", "x"], ["lat", "lon"], ["row", "column"]):
            value = value.T
    return floats_of(value, "#/surface/heights")


def floats_of(value: Any, pointer: str) -> Floats:
    """Figures as an array, NaN where one is masked or missing, in lists of arrays too.

    Raises `InvalidJob` for what is no figure: text, complex numbers, dates, structures.
    """
    try:
        array = np.asarray(_without_masks(value))
    except ValueError:
        fault = Fault(pointer, "wrong_type", "has lines of different lengths")
        raise InvalidJob([fault], "figures are wanted") from None
    if array.dtype.kind in "cbMmV":
        words = f"figures are wanted, not {array.dtype}"
        words += ": give one of its fields" if array.dtype.names else ""
        raise InvalidJob([Fault(pointer, "wrong_type", words)], "figures are wanted")
    try:
        return array.astype(float)
    except (TypeError, ValueError):
        pass
    for place in np.ndindex(array.shape):
        try:
            np.asarray(array[place]).astype(float)
        except (TypeError, ValueError):
            at = "/".join([pointer, *map(str, place)])
            said = f"“{array[place]}” is no number"
            if re.fullmatch(r"\s*[-+]?\d*,\d+\s*", str(array[place])):
                said += f": {DECIMAL_COMMA}"
            fault = Fault(at, "wrong_type", said)
            raise InvalidJob([fault], "figures are wanted") from None
    raise InvalidJob(
        [Fault(pointer, "wrong_type", "is no array of figures")], "figures are wanted"
    )


def _without_masks(value: Any) -> Any:
    """The same as `without_mask`, for what stands in lists too."""
    if isinstance(value, (float, int, str)):
        return value
    if isinstance(value, (list, tuple)):
        return [_without_masks(one) for one in value]
    return without_mask(value)
