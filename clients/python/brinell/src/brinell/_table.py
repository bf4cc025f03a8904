"""Tables of tests and hardness profiles as laboratories' programs write them.

The page reads them by the same rules; `tests/measured/tables.json` has cases that both meet.
"""

from __future__ import annotations

import json
import math
import os
import re
import statistics
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass, field
from importlib.resources import files
from numbers import Real
from pathlib import Path
from typing import Literal, TypeAlias

from ._errors import Fault, InvalidJob
from ._lengths import LENGTHS
from ._surface import _text_of

Measure: TypeAlias = Literal["engineering", "true", "plastic", "indentation"]

_WORDS: dict[str, dict[str, str]] = json.loads(
    files(__package__).joinpath("columns.json").read_text("utf-8")
)
_ROLES = {name: re.compile(text) for name, text in _WORDS["roles"].items()}
_FACTS = {name: re.compile(text) for name, text in _WORDS["facts"].items()}
_STRESSES = {
    **dict.fromkeys(["MPa", "N/mm²"], 1.0),
    "Pa": 1e-6,
    "kPa": 1e-3,
    "GPa": 1e3,
    "bar": 0.1,
    "kN/mm²": 1e3,
    "psi": 6894.757293168e-6,
    "ksi": 6.894757293168,
    "kgf/mm²": 9.80665,
}
_FORCES = {"N": 1.0, "µN": 1e-6, "uN": 1e-6, "mN": 1e-3, "kN": 1e3, "MN": 1e6, "kgf": 9.80665}
_FORCES["lbf"] = 4.4482216152605
_STRAINS = {
    **dict.fromkeys(["1", "-", "m/m", "mm/mm", "in/in"], 1.0),
    "%": 1e-2,
    "‰": 1e-3,
    "µm/m": 1e-6,
    "µε": 1e-6,
    "µstrain": 1e-6,
}
_KINDS = {"strain": _STRAINS, "stress": _STRESSES, "force": _FORCES, "length": LENGTHS}
_OF = {
    **dict.fromkeys(["plastic_strain", "true_strain", "engineering_strain", "strain"], "strain"),
    **dict.fromkeys(["true_stress", "engineering_stress", "stress"], "stress"),
    **dict.fromkeys(["extension", "travel", "penetration", "depth"], "length"),
    "force": "force",
}
_PAIRS: list[tuple[Measure | Literal["force"], list[str], list[str]]] = [
    ("plastic", ["plastic_strain"], ["true_stress", "stress", "engineering_stress"]),
    ("true", ["true_strain"], ["true_stress", "stress"]),
    ("engineering", ["engineering_strain", "strain"], ["engineering_stress", "stress"]),
    ("true", ["strain"], ["true_stress"]),
    ("force", ["extension", "travel"], ["force"]),
    ("indentation", ["penetration", "travel", "depth"], ["force"]),
]
STEEL = 210_000.0
"""Young's modulus [MPa], by which the unit of strains is told."""
# A record whose largest travel is shorter is one of an indentation [mm].
_SMALL = 0.1
# Part of the largest stress below which the first is that of a record, not of a curve from yield.
_BEGINS = 0.2
# Ratio to Young's modulus within which a first slope tells the unit of the strains.
_ALIKE = 3
_EXTENSOMETER = re.compile(r"extenso|fein|strain 1|dehnungsaufnehmer", re.IGNORECASE)
_FIGURE = re.compile(r"[^\w([]*\d")
_NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?", re.IGNORECASE)
_COMMA = re.compile(r"[-+]?\d*,\d+(e[-+]?\d+)?", re.IGNORECASE)
_AMBIGUOUS = re.compile(r"[-+]?[1-9]\d{0,2},\d{3}")
# Most letters of a line of a few figures: beyond it a file is none of lines.
_LONGEST = 1000
_UNSIGNED = "as true strain and true stress without signs"
# Dashes that programs write for a minus.
_DASH = re.compile("[\u2010-\u2013\u2212\ufe63\uff0d]")


@dataclass(frozen=True)
class Record:
    """Two columns of a table."""

    points: list[list[float]]
    """Strain and stress [MPa], depth [mm] and hardness, or penetration [mm] and force [N]."""
    measure: Measure | None
    """What a test measured; `None` of a profile."""
    scale: str = ""
    """The scale of a hardness, where the file says it."""
    notes: list[str] = field(default_factory=list)
    """What was read."""


@dataclass(frozen=True)
class _Column:
    name: str
    unit: str
    role: str


def _refuse(code: str, detail: str) -> InvalidJob:
    return InvalidJob([Fault("#/table", code, detail)], "not taken as a table")


def _one(unit: str, kind: str) -> float | None:
    """One of a unit in mm, N and MPa; `None` where it is none of the kind."""
    return _KINDS[kind].get(re.sub(r"\^?2$", "²", "".join(unit.split()).replace("μ", "µ")))


def _is_unit(name: str) -> bool:
    return any(_one(name, kind) is not None for kind in _KINDS)


def _plain(name: str) -> str:
    text = unicodedata.normalize("NFC", name).lower()
    return re.sub(r"[\s_.:'\"/-]", "", re.sub(r"[\[(][^\])]*[\])]?", "", text))


def _parts(header: str) -> tuple[str, str]:
    """Name and unit of a header: the unit in brackets, or behind the last words."""
    if bracketed := re.fullmatch(r"(.*?)[\[(]([^\])]+)[\])]", header):
        return bracketed[1].strip(), bracketed[2].strip()
    for at in (0, *(match.end() for match in re.finditer(r"[\s/,_]", header))):
        if _is_unit(header[at:]):
            return re.sub(r"(\sin)?[\s/,_]*$", "", header[:at]), header[at:].strip()
    return header, ""


def _role(name: str, unit: str) -> str:
    word = _plain(name)
    for role, called in _ROLES.items():
        fits = not unit or role not in _OF or _one(unit, _OF[role]) is not None
        if word and fits and called.fullmatch(word):
            return role
    return ""


def _separator(lines: Sequence[str]) -> str:
    figures = [line for line in lines if re.match(r"[\s\"]*[-+.,]?\d", line)]
    for among in (figures, lines):
        for one in "\t;":
            if any(one in line for line in among):
                return one
    if any(re.match(r'\s*".*",', line) for line in figures):
        return ","
    if figures and all("," in line and not re.search(r"\d\s+[-+.\d]", line) for line in figures):
        return ","
    return " "


def _cells(line: str, separator: str) -> list[str]:
    bare = re.sub(r"^\s*(#|%(?!\s*[;,\t])|//)", "", line)
    quoted = r'(?=(?:[^"]*"[^"]*")*[^"]*$)'
    parts = bare.split() if separator == " " else re.split(separator + quoted, bare)
    cells = [part.strip().strip('"').strip() for part in parts]
    while cells and not cells[-1]:
        cells.pop()
    return cells


def _columns(headers: list[list[str]]) -> list[_Column]:
    def is_named(cells: list[str]) -> bool:
        known = [cell for cell in cells if _role(*_parts(cell))]
        return len(cells) > 1 and not re.match(r"[-+]?[.,\d]", cells[1]) and len(known) > 1

    def is_of_units(cells: list[str]) -> bool:
        known = r"[\[(].*[\])]|s|sec|min|°C|Hz|"
        return len(cells) > 1 and all(
            re.fullmatch(known, cell) or _is_unit(cell) for cell in cells
        )

    named = next((cells for cells in reversed(headers) if is_named(cells)), [])
    units = next(
        (cells for cells in reversed(headers) if cells is not named and is_of_units(cells)), []
    )
    columns = []
    for k, cell in enumerate(named):
        below = re.sub(r"^[\[(]|[\])]$", "", units[k] if k < len(units) else "").strip()
        name, beside = _parts(cell)
        unit = below if _is_unit(below) else beside if _is_unit(beside) else ""
        columns.append(_Column(cell, unit, _role(name if unit == beside else cell, unit)))
    return columns


def _facts(headers: list[list[str]]) -> dict[str, float]:
    """Figures of the specimen in mm and mm²."""
    facts: dict[str, float] = {}
    for cells in headers:
        whole, *rest = cells if len(cells) > 1 else re.split(r"[:=]\s*", cells[0])
        split = re.fullmatch(r"([-+\d.,e]+)\s*(.*)", rest[0]) if rest else None
        try:
            value = _float(split[1], _has_comma(split[1])) if split else 0.0
        except InvalidJob:
            continue  # Who reads the record asks for it.
        if not split or value <= 0:
            continue
        name, unit = _parts(whole)
        fact = next((one for one, called in _FACTS.items() if called.fullmatch(_plain(name))), "")
        of = split[2] or unit or (rest[1] if len(rest) > 1 else "") or "mm"
        one = _one(re.sub(r"\^?[2²]$", "", of.strip("[]()")), "length")
        if fact and one:
            facts[fact] = value * one ** (2 if fact == "section" else 1)
    if "section" not in facts and "diameter" in facts:
        facts["section"] = math.pi / 4 * facts["diameter"] ** 2
    elif "section" not in facts and {"width", "thickness"} <= facts.keys():
        facts["section"] = facts["width"] * facts["thickness"]
    return facts


def _has_comma(text: str) -> bool:
    """Whether a text is a number with a comma that cannot group thousands."""
    return bool(_COMMA.fullmatch(text) and not _AMBIGUOUS.fullmatch(text))


def _float(text: str, commas: bool) -> float:
    if _AMBIGUOUS.fullmatch(text) and not commas:
        raise _refuse("not_understood", f"“{text}” has a decimal comma, or one of thousands")
    if commas and "." in text:
        raise _refuse("not_understood", f"“{text}” has a point, and others a decimal comma")
    point = text.replace(",", ".") if _COMMA.fullmatch(text) else text
    if not _NUMBER.fullmatch(point):
        raise _refuse("not_understood", f"“{text}” is not a number")
    value = float(point)
    if math.isinf(value) or (value == 0 and re.search("[1-9]", re.sub("(?i)e.*", "", point))):
        raise _refuse("not_understood", f"“{text}” is too large or too close to 0 for a number")
    return value


def _strain_unit(points: list[list[float]], modulus: float) -> str:
    """Per cent where the first slope is Young's modulus by it, and not a hundredth."""
    most = max(stress for _, stress in points)
    slopes = [s / e for e, s in points[1:] if e > 0 and 0 < s < 0.5 * most]
    slope = statistics.median_high(slopes) if slopes else math.nan
    for unit, times in (("%", 100), ("1", 1)):
        if modulus / _ALIKE < slope * times < modulus * _ALIKE:
            return unit
    return ""


def read_table(
    source: str | os.PathLike[str],
    *,
    section: float | None = None,
    gauge_length: float | None = None,
    units: Sequence[str] | None = None,
    young_modulus: float = STEEL,
) -> Record:
    """A record of a test or a hardness profile in a file of text.

    Any lines may stand above the figures. Columns are known by their names in English, German and
    French, units by brackets, by a line of their own, or by `units`. Strains without a unit are in
    per cent where the first slope says so.

    Args:
        source: name of the file.
        section: of the specimen [mm²], for force over travel, where the file does not say it.
        gauge_length: [mm], likewise.
        units: of the two columns, in place of those of the file.
        young_modulus: [MPa], by which the unit of strains is told.

    Raises:
        InvalidJob: what is lacking is named.
    """
    if units is not None and [type(one) for one in units] != [str, str]:
        raise _refuse("wrong_type", "units= are two names, of the first and the second column")
    given = {"section": section, "gauge_length": gauge_length, "young_modulus": young_modulus}
    for name, value in given.items():
        is_figure = isinstance(value, Real) and 0 < value < math.inf
        if not is_figure and (value is not None or name == "young_modulus"):
            raise _refuse("wrong_type", f"{name}= is a figure above 0")
    text = _text_of(Path(source).read_bytes())
    if text is None:
        raise _refuse("not_understood", f"{Path(source).name} is no text")
    return _read(text, section, gauge_length, units, young_modulus)


def _read(
    text: str,
    section: float | None,
    gauge_length: float | None,
    given: Sequence[str] | None,
    modulus: float,
) -> Record:
    plain = _DASH.sub("-", text.lstrip("\ufeff"))
    lines = [line for line in re.split(r"\r\n?|\n", plain) if line.strip()]
    if any(len(line) > _LONGEST for line in lines):
        detail = f"a line has more than {_LONGEST} letters: a point has a line of its own"
        raise _refuse("not_understood", detail)
    separator = _separator(lines)
    rows = [cells for cells in (_cells(line, separator) for line in lines) if cells]

    def figures(cells: list[str]) -> int:
        return sum(1 for cell in cells if _FIGURE.match(cell))

    def is_said(cells: list[str]) -> bool:
        return cells[0][:1].isalpha() and figures(cells) < 2 and len(cells) < 4

    def is_body(cells: list[str]) -> bool:
        return len(cells) > 1 and figures(cells) > 0 and not is_said(cells)

    start = next((k for k, cells in enumerate(rows) if is_body(cells)), len(rows))
    headers, body = rows[:start], rows[start:]
    while body and is_said(body[-1]):
        body.pop()
    if not body:
        raise _refuse("not_understood", "there are no figures in it")
    columns = _columns(headers)
    commas = any(_has_comma(cell) for row in body for cell in row)

    def place(roles: list[str]) -> int:
        those = [k for role in roles for k, one in enumerate(columns) if one.role == role]
        best = [k for k in those if _EXTENSOMETER.search(columns[k].name)]
        return (best or those or [-1])[0]

    hard = [k for k, one in enumerate(columns) if one.role == "hardness" or _is_hrc(one.name)]
    if hard:
        return _profile(columns, hard, body, commas, headers)
    pair = next((p for p in _PAIRS if place(p[1]) >= 0 and place(p[2]) >= 0), None)
    at = [place(pair[1]), place(pair[2])] if pair else [0, 1]
    if not pair and (columns or len(body[0]) != 2):
        raise _refuse("missing", "no columns of strain and stress, or of force and travel")
    units = list(given or ([columns[k].unit for k in at] if pair else ["", ""]))
    full = [row for row in body if all(k < len(row) and row[k] for k in at)]
    points = [[_float(row[k], commas) for k in at] for row in full]
    names = [columns[k].name if columns else f"column {k + 1}" for k in at]
    if all(up <= 0 for _, up in points):
        detail = f"“{names[1]}” has no figure above 0: write a test in compression {_UNSIGNED}"
        raise _refuse("not_understood", detail)
    notes = [f"{len(points)} points read"]
    is_force = bool(pair and pair[2] == ["force"])
    is_sure = any(one.role.startswith("engineering") for one in columns)
    begins_at_nothing = points[0][1] < _BEGINS * max(stress for _, stress in points)
    # Without a word of what they are, figures that begin at yield are a hardening curve.
    is_plastic = bool(pair and pair[0] == "plastic") or not (
        is_force or is_sure or begins_at_nothing
    )
    if is_plastic and max(strain for strain, _ in points) <= 1:
        # Plastic strain is a share, as the law has it.
        units[0] = units[0] or "1"
    if not is_force and not (units[0] and units[1]):
        one = _one(units[1] or "MPa", "stress") or math.nan
        told = _strain_unit([[e, s * one] for e, s in points], modulus)
        units[0] = units[0] or told
        if told and _STRAINS.get(told) == _one(units[0], "strain"):
            units[1] = units[1] or "MPa"
        notes.append(f"strain in {units[0]}, stress in {units[1]}, by the first slope")
    for axis, kind in enumerate(("length", "force") if is_force else ("strain", "stress")):
        factor = _one(units[axis], kind)
        if factor is None:
            raise _refuse("missing", f"the unit of “{names[axis]}” is not said: units=[..., ...]")
        for point in points:
            point[axis] *= factor
    if is_force:
        return _of_force(points, pair, section, gauge_length, _facts(headers), notes)
    measure: Measure = "true" if pair and pair[0] == "true" else "engineering"
    return Record(points, "plastic" if is_plastic else measure, notes=notes)


def _of_force(
    points: list[list[float]],
    pair: tuple[str, list[str], list[str]] | None,
    section: float | None,
    gauge_length: float | None,
    facts: dict[str, float],
    notes: list[str],
) -> Record:
    section = section or facts.get("section")
    length = gauge_length or facts.get("gauge_length")
    reach = max(abs(travel) for travel, _ in points)
    if (pair and pair[0] == "indentation") or (reach < _SMALL and not (section and length)):
        return Record(points, "indentation", notes=notes)
    if not (section and length):
        raise _refuse("missing", "force over travel: section= and gauge_length= of the specimen")
    notes.append(f"section {section:.6g} mm², gauge length {length:g} mm")
    return Record([[t / length, f / section] for t, f in points], "engineering", notes=notes)


def _is_hrc(name: str) -> bool:
    return bool(re.search(r"(?<![a-z])HR\s?C|rockwell c", name, re.IGNORECASE))


def _profile(
    columns: list[_Column],
    hard: list[int],
    body: list[list[str]],
    commas: bool,
    headers: list[list[str]],
) -> Record:
    deep = [
        k
        for k, one in enumerate(columns)
        if _ROLES["depth"].fullmatch(_plain(_parts(one.name)[0]))
    ]
    for what, found in (("depth", deep), ("hardness", hard)):
        if len(found) != 1:
            names = ", ".join(columns[k].name for k in found)
            raise _refuse("not_understood", f"{len(found)} columns of {what}: {names}")
    at = [deep[0], hard[0]]
    unit = columns[at[0]].unit
    if not unit:
        lines = [" ".join(cells) for cells in headers]
        stray = [line for line in lines if any(map(_is_unit, line.split()))]
        if stray:
            raise _refuse("missing", f"“{stray[0]}” may be the unit of the depths: name it there")
    factor = _one(unit or "mm", "length") or 1.0
    full = [[*row, *[""] * len(columns)] for row in body]
    points = [[_float(row[at[0]], commas) * factor, _float(row[at[1]], commas)] for row in full]
    name = columns[at[1]].name
    scale = "HRC" if _is_hrc(name) else "HV" if re.search(r"HV|VHN|DPH", name) else ""
    return Record(points, None, scale, [f"{len(points)} points read"])
