"""Progress bars (tqdm)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ._core import Event


class Progress:
    """A progress bar or a callback for the events of one job; `None` without either."""

    def __init__(self, wanted: bool | Callable[[Event], object]) -> None:
        self._wanted = wanted
        self._bar: Any = None

    def __enter__(self) -> Callable[[Event], object] | None:
        if callable(self._wanted):
            return self._wanted
        self._bar = _tqdm(unit=" iterations") if self._wanted else None
        return self._show if self._bar is not None else None

    def _show(self, event: Event) -> None:
        if event.kind == "iteration":
            self._bar.update()
            residual = event.data["equilibrium_residual"]
            self._bar.set_postfix_str(f"out of balance {residual:.1e}", refresh=False)
        else:
            self._bar.set_description_str(str(event.data["status"]) + " ", refresh=False)

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.close()


class Bar:
    """A bar for many jobs."""

    def __init__(self, wanted: bool, jobs: Any) -> None:
        total = len(jobs) if hasattr(jobs, "__len__") else None
        self._bar = _tqdm(total=total, unit=" jobs") if wanted else None

    def __enter__(self) -> Callable[[], object]:
        return self._bar.update if self._bar is not None else lambda: None

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.close()


def _tqdm(**options: Any) -> Any:
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    return tqdm(**options)
