"""Figures of arrays and tables with their holes: what is masked or missing is no number here."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]

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
    return np.asarray(without_mask(value), dtype=float)
