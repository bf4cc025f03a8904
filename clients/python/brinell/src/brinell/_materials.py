"""Materials with the source of every figure, from `api/materials.json`."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from functools import lru_cache
from importlib.resources import files
from typing import Any

from . import models

__all__ = ["Materials", "materials", "steels"]


class Materials(Mapping[str, models.Deformable]):
    """Materials by their names, capitals and spaces aside. In mm, N and MPa."""

    def __init__(self, kind: str | None = None) -> None:
        self._kind = kind

    def __getitem__(self, name: str) -> models.Deformable:
        return models.Deformable.model_validate(self._entry(name)["material"])

    def source(self, name: str) -> str:
        """Where the figures of a material come from."""
        entry = self._entry(name)
        return f"{entry['name']}. {entry['source']}"

    def _entry(self, name: str) -> dict[str, Any]:
        wanted = _normal(name)
        for entry in self._entries():
            if wanted in (_normal(entry["name"]), *map(_normal, entry["keys"])):
                return entry
        raise KeyError(f"no material {name!r}; there are {', '.join(self)}")

    def _entries(self) -> list[dict[str, Any]]:
        return [entry for entry in _library() if self._kind in (None, entry["kind"])]

    def __iter__(self) -> Iterator[str]:
        return (key for entry in self._entries() for key in entry["keys"])

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def __repr__(self) -> str:
        lines = [
            f"  {', '.join(entry['keys']):24} {entry['name']}. {entry['source']}"
            for entry in self._entries()
        ]
        return "\n".join(["materials, in mm, N and MPa:", *lines])


def _normal(name: str) -> str:
    return "".join(name.lower().split())


@lru_cache(maxsize=1)
def _library() -> list[dict[str, Any]]:
    library = json.loads(files(__package__).joinpath("materials.json").read_text("utf-8"))
    entries: list[dict[str, Any]] = library["materials"]
    return entries


materials = Materials()
"""Every material of the library."""

steels = Materials("steel")
"""The steels among them."""
