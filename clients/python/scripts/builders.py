"""Writes the builders of shapes and hardening laws from the interface document.

python clients/python/scripts/builders.py [OUTPUT]
"""

import json
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[3]
OUTPUT = Path(__file__).resolve().parents[1] / "brinell/src/brinell/_builders.py"

HEAD = '''# Generated from api/openapi.json by clients/python/scripts/builders.py; do not edit.
"""Bodies by their shape, and hardening laws."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ._build import Material, Number, Support, build_body, build_law
from .models import {models}

__all__ = [{names}]
'''

# One source for the types of arguments that are not single figures.
TYPES = {
    "points": "Sequence[tuple[Number, Number]] | Sequence[Sequence[Number]] | Any",
    "interpolation": "str | None",
    "profile": "str | None",
    "over_depth": "Any",
    "backstress": "Sequence[Any] | None",
}


def arguments(schema: dict[str, Any], skip: str) -> list[tuple[str, str, bool, str]]:
    """Name, type, whether required, and description of each argument, required ones first."""
    required = schema["required"]
    rows = []
    for name, member in schema["properties"].items():
        if name == skip:
            continue
        needed = name in required
        kind = TYPES.get(name, "Number" if needed else "Number | None")
        rows.append((name, kind, needed, member["description"].split(" Range:")[0]))
    return sorted(rows, key=lambda row: (not row[2], list(schema["properties"]).index(row[0])))


def wrapped(text: str, indent: str, width: int = 100) -> str:
    """The text in lines, those after the first indented."""
    lines, line = [], ""
    for word in text.split():
        room = width - (len(indent) if lines else 4)
        if line and len(line) + 1 + len(word) > room:
            lines.append(line)
            line = word
        else:
            line = f"{line} {word}".strip()
    return ("\n" + indent).join([*lines, line])


def function(name: str, schema: dict[str, Any], model: str, skip: str, answer: str) -> str:
    rows = arguments(schema, skip)
    of_body = answer == "ContactBody"
    lines = [f"def {name}(", "    *,"]
    lines += [
        f"    {n}: {kind}{'' if needed else ' = None'}," for n, kind, needed, _ in rows if needed
    ]
    if of_body:
        lines.append("    material: Material,")
    lines += [f"    {n}: {kind} = None," for n, kind, needed, _ in rows if not needed]
    if of_body:
        lines.append("    support: Support | None = None,")
    lines.append(f") -> {answer}:")
    summary = schema["description"].split(". ")[0].rstrip(".") + "."
    docs = [f'    """{wrapped(summary, "    ")}', "", "    Args:"]
    docs += ["        " + wrapped(f"{n}: {text}", "            ", 96) for n, _, _, text in rows]
    if of_body:
        docs += ["        material: a name among `materials`, `material(...)` or `rigid`."]
        docs += ['        support: how its far boundary is held: "clamped" (default) or "roller".']
    docs.append('    """')
    values = ", ".join(f"{n}={n}" for n, *_ in rows)
    call = (
        f"build_body({model}, material, support, {values})"
        if of_body
        else f"build_law({model}, {values})"
    )
    return "\n".join([*lines, *docs, f"    return {call}", ""])


def main() -> None:
    schemas = json.loads((ROOT / "api/openapi.json").read_text("utf-8"))["components"]["schemas"]
    functions, names, models = [], [], ["ContactBody"]
    for union, skip in (("Shape", "type"), ("Plasticity", "law")):
        for word, reference in schemas[union]["discriminator"]["mapping"].items():
            model = reference.rsplit("/", 1)[1]
            answer = "ContactBody" if union == "Shape" else model
            functions.append(function(word, schemas[model], model, skip, answer))
            names.append(word)
            models.append(model)
    imports = "(\n    " + ",\n    ".join(sorted(models)) + ",\n)"
    listed = "\n    " + ",\n    ".join(f'"{name}"' for name in sorted(names)) + ",\n"
    text = HEAD.format(models=imports, names=listed) + "\n\n" + "\n\n".join(functions)
    output = Path(sys.argv[1]) if len(sys.argv) > 1 else OUTPUT
    output.write_text(text, "utf-8")


if __name__ == "__main__":
    main()
