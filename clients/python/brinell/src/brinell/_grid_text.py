"""Heights in files of text: grids of Gwyddion, Surfer and ESRI, plain grids, lists of x, y, z.

Every line above the figures is understood or refused, so that no unit or size is lost.
"""

from __future__ import annotations

import csv
import re
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from ._arrays import DECIMAL_COMMA, Floats
from ._lengths import is_length, length_in_mm
from ._plain import grouped

# Figures that Surfer and others put where nothing was measured: all from here on.
BLANK = 1.7e38


class NotUnderstood(ValueError):
    """A file of text says something that is not understood; the message names the line."""


@dataclass
class Grid:
    """Heights as a file has them: its units by their names, empty where it says none."""

    heights: Floats
    """`[i, j]` at the i-th x and the j-th y, NaN where there is none."""
    spacing: tuple[float, float] | None = None
    """Distances along x and y, in the unit `across`."""
    across: str = ""
    """Unit of the distances."""
    up: str = ""
    """Unit of the heights."""
    notes: list[str] = field(default_factory=list)
    """What was read and taken for granted."""


HOLE = re.compile(
    r"-?nan(\(.*\))?|n/?a|null|none|bad|void|masked|\*+|-{1,3}|\?+|no ?data|#n/?[av]|#wert!"
    r"|#value!|[-+]?1[.,]#(qnan|snan|ind|inf).*|[-+]?inf(inity)?",
    re.IGNORECASE,
)
NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?", re.IGNORECASE)
COMMA = re.compile(r"[-+]?\d*,\d+(e[-+]?\d+)?", re.IGNORECASE)
# What stands behind a decimal comma, and no figure begins with.
DIGITS = re.compile(r"[-+]?0\d+|-0")
# A decimal comma or a thousand.
AMBIGUOUS = re.compile(r"[-+]?[1-9]\d{0,2},\d{3}")
SIGN = re.compile(r"\s*(#|%|//|!|\*|;)+\s*")

_SIZE = "length size range scan scansize scanrange dimension extent länge taille"
_STEP = (
    "spacing step stepsize pitch resolution pixelsize inc increment delta d abstand schrittweite "
    "auflösung cellsize pas"
)
_COUNT = "pixel pixels point points sample samples count res punkte"


def _on(axis: str, words: str) -> list[str]:
    return [one for word in words.split() for one in (axis + word, word + axis)]


def _these(words: str) -> set[str]:
    return set(words.split())


# Keys of header lines, lower case without spaces, dots and dashes, by what they say.
_KEYS: dict[str, set[str]] = {
    "width": {"width", "breite", "largeur", *_on("x", _SIZE)},
    "length": {"height", "höhe", "hauteur", *_on("y", _SIZE)},
    "extent": _these(
        "size range scansize scanrange scanbereich größe taille fieldofview imagesize "
        "physicalsize physicalsizes"
    ),
    "dx": {"pixelwidth", "pixelbreite", "largeurdupixel", *_on("x", _STEP)},
    "dy": {"pixelheight", "pixelhöhe", "hauteurdupixel", *_on("y", _STEP)},
    "spacing": _these(
        "spacing pixelsize pixelspacing cellsize resolution lateralresolution step "
        "stepsize pitch samplinginterval samplingdistance samplingstep increment "
        "pixelgröße schrittweite abstand punktabstand messpunktabstand auflösung "
        "lateraleauflösung pas pasd'échantillonnage tailledupixel tailledepixel "
        "résolution"
    ),
    "up": _these(
        "unit units valueunit valueunits heightunit heightunits zunit zunits dataunit "
        "dataunits einheit einheiten werteinheit werteinheiten werteeinheit höheneinheit "
        "zeinheit einheitderwerte einheitderhöhe einheitderhöhen unité unités "
        "unitédesvaleurs unitésdesvaleurs unitédevaleur unitéz unitédehauteur"
    ),
    "across": _these(
        "lateralunit lateralunits xyunit xyunits xunit xunits yunit yunits lengthunit "
        "lateraleeinheit xyeinheit xeinheit yeinheit unitélatérale unitéxy unitéx unitéy"
    ),
    "nx": {
        *_these(
            "nx ncols cols columns numberofcolumns spalten spaltenzahl colonnes "
            "nombredecolonnes pixelsperline pointsperline"
        ),
        *_on("x", _COUNT),
    },
    "ny": {
        *_these(
            "ny nrows rows lines numberofrows numberoflines zeilen zeilenzahl lignes "
            "nombredelignes profiles"
        ),
        *_on("y", _COUNT),
    },
    "nodata": _these(
        "nodata nodatavalue novalue missing missingvalue missingdata blank blankvalue "
        "blankingvalue invalid invalidvalue badvalue badpixelvalue undefined "
        "undefinedvalue ungültig fehlwert keinwert keinedaten valeurmanquante "
        "valeurabsente absent"
    ),
    "said": _these(
        "channel kanal canal title titel titre name file filename fileformat filetype "
        "datei dateiname fichier nom nomdufichier date datum time uhrzeit zeit heure "
        "datetime operator bediener opérateur user benutzer instrument device gerät "
        "appareil comment comments kommentar commentaire commentaires remark remarks "
        "bemerkung sample samplename sampleid probe échantillon objective objektiv "
        "objectif software version format createdby erstellt exportedby exportedfrom "
        "source startofdata data daten données type measurement messung mesure "
        "serialnumber magnification vergrößerung company project projekt xoffset yoffset "
        "offsetx offsety"
    ),
}


def read_grid(text: str, skip: tuple[int, ...] = ()) -> Grid:
    """Heights of a text, or `NotUnderstood`.

    Lines of the numbers in `skip`, counted from 1, are left out.
    """
    lines = [
        "" if number in skip else line
        for number, line in enumerate(re.split(r"\r\n?|\n", text.lstrip("\ufeff")), 1)
    ]
    # Dashes that programs put for a minus.
    lines = [re.sub("[\u2010-\u2013\u2212\ufe63\uff0d]", "-", line) for line in lines]
    filled = [(number, line) for number, line in enumerate(lines, 1) if line.strip()]
    if not filled:
        raise NotUnderstood("the file is empty")
    first = filled[0][1].strip()
    if first == "DSAA":
        return _surfer(filled[1:])
    if re.match(r"(ncols|nrows)\s+\d", first, re.IGNORECASE):
        return _esri(filled)
    blank = {k for k, line in enumerate(lines, 1) if not line.strip() and k not in skip}
    return _plain_grid(filled, blank)


def _is_comment(line: str) -> bool:
    """Whether a line begins with a sign, and not with a word for a hole such as `#N/A`."""
    first = re.split(r"[\s;,]", line.strip(), maxsplit=1)[0]
    return bool(SIGN.match(line)) and first != "" and not HOLE.fullmatch(first)


def _without_sign(line: str) -> str:
    return SIGN.sub("", line, count=1) if _is_comment(line) else line


def _float(number: int, word: str) -> float:
    if HOLE.fullmatch(word):
        return float("nan")
    if not NUMBER.fullmatch(word):
        raise NotUnderstood(f"line {number}: {_quoted(word)} is not a number")
    return float(word)


def _quoted(text: str) -> str:
    plain = text.strip()
    return f"“{plain[:40]}…”" if len(plain) > 40 else f"“{plain}”"


def _words(lines: list[tuple[int, str]], count: int) -> Floats:
    """The figures of lines that may end anywhere; there have to be `count`."""
    decimal = any(COMMA.fullmatch(word) for _, line in lines for word in line.split())
    figures = [
        _float(number, word.replace(",", ".") if decimal else word)
        for number, line in lines
        for word in line.split()
    ]
    if len(figures) != count:
        raise NotUnderstood(
            f"the head says {grouped(count)} heights, and there are {grouped(len(figures))}"
        )
    return np.array(figures)


def _surfer(lines: list[tuple[int, str]]) -> Grid:
    if len(lines) < 5:
        raise NotUnderstood("a grid of Surfer has five lines above its heights")
    head = [[_float(number, word) for word in line.split()] for number, line in lines[:4]]
    if any(len(two) != 2 for two in head) or min(head[0]) < 2:
        raise NotUnderstood(
            "lines 2 to 5 of a grid of Surfer have two figures each: counts, x, y and z from to"
        )
    nx, ny = (int(one) for one in head[0])
    rows = _words(lines[4:], nx * ny).reshape(ny, nx)
    rows = np.where(rows >= BLANK, np.nan, rows)
    (x0, x1), (y0, y1), (low, high) = head[1:]
    reached = (np.nanmin(rows), np.nanmax(rows)) if np.isfinite(rows).any() else (low, high)
    if max(abs(reached[0] - low), abs(reached[1] - high)) > 1e-3 * max(high - low, 1e-300):
        raise NotUnderstood(
            f"line 5 says heights from {low:g} to {high:g}, and they go from {reached[0]:g} to "
            f"{reached[1]:g}"
        )
    notes = ["a grid of Surfer: lines along x, the first at the smallest y"]
    spacing = ((x1 - x0) / (nx - 1), (y1 - y0) / (ny - 1))
    return Grid(rows.T.copy(), _positive(spacing), notes=notes)


def _positive(spacing: tuple[float, float]) -> tuple[float, float]:
    if not min(spacing) > 0 or not np.isfinite(spacing).all():
        raise NotUnderstood(f"the head makes distances of {spacing[0]:g} and {spacing[1]:g}")
    return spacing


_ESRI = (
    "ncols",
    "nrows",
    "xllcorner",
    "xllcenter",
    "yllcorner",
    "yllcenter",
    "cellsize",
    "dx",
    "dy",
)


def _esri(lines: list[tuple[int, str]]) -> Grid:
    head: dict[str, float] = {}
    while lines and re.match(r"\s*[A-Za-z_]", lines[0][1]) and len(lines[0][1].split()) == 2:
        key, value = lines[0][1].lower().split()
        if key not in (*_ESRI, "nodata_value"):
            break
        head[key] = _float(lines[0][0], value.replace(",", "."))
        lines = lines[1:]
    lacking = [key for key in ("ncols", "nrows") if key not in head]
    if lacking or not ("cellsize" in head or ("dx" in head and "dy" in head)):
        raise NotUnderstood(f"a grid of ESRI lacks {' and '.join(lacking) or 'cellsize'}")
    nx, ny = int(head["ncols"]), int(head["nrows"])
    rows = _words(lines, nx * ny).reshape(ny, nx)
    if "nodata_value" in head:
        rows = np.where(rows == head["nodata_value"], np.nan, rows)
    spacing = (head.get("dx", head.get("cellsize", 0)), head.get("dy", head.get("cellsize", 0)))
    notes = ["a grid of ESRI: lines along x, the first at the largest y"]
    return Grid(rows[::-1].T.copy(), _positive(spacing), notes=notes)


def _plain_grid(lines: list[tuple[int, str]], blank: set[int]) -> Grid:
    separator = _separator(lines)
    cells = [(number, line, _cells(line, separator)) for number, line in lines]
    is_body = [not _is_comment(line) and _is_data(row) for _, line, row in cells]
    if True not in is_body:
        number, _, row = cells[len(cells) // 2]
        wrong = next((one for one in row if not _is_figure(one) and re.search(r"\d", one)), None)
        if wrong is None:
            raise NotUnderstood("no figures in it")
        raise NotUnderstood(f"line {number}: {_quoted(wrong)} is not a number")
    start = is_body.index(True)
    head = [(n, line, row) for n, line, row in cells[:start]]
    body: list[tuple[int, list[str]]] = []
    for (number, line, row), data in zip(cells[start:], is_body[start:], strict=True):
        if data:
            body.append((number, row))
        elif _is_comment(line):
            if re.search(r"\w", line):
                raise NotUnderstood(
                    f"line {number}: {_quoted(line)} stands among the figures: another map? "
                    f"skip=[{number}] leaves the line out"
                )
        else:
            wrong = next((w for w in row if not _is_figure(w)), line)
            raise NotUnderstood(f"line {number}: {_quoted(wrong)} is not a number")
    # A separator at the end of every line.
    if all(row[-1] == "" for _, row in body):
        body = [(number, row[:-1]) for number, row in body]
    if separator == ",":
        for number, row in body:
            wrong = next((one for one in row if DIGITS.fullmatch(one)), None)
            if wrong is not None:
                raise NotUnderstood(
                    f"line {number}: {_quoted(wrong)} between commas: commas between figures, or "
                    f"decimal commas? {DECIMAL_COMMA}"
                )
    values = _figures(body)
    said = _Header()
    columns = len(values[0])
    between = [[k for k in range(a + 1, b) if k in blank] for (a, _), (b, _) in pairwise(body)]
    if columns > 3 and any(between) and not all(between):
        number = next(one[0] for one in between if one)
        raise NotUnderstood(
            f"line {number} is blank, with figures above and below: another map? skip=[{number}] "
            "leaves the line out"
        )
    for number, line, row in head:
        said.take(number, line, row, columns == 3)
    uneven = next((k for k, row in enumerate(values) if len(row) != columns), None)
    if uneven is not None:
        raise NotUnderstood(
            f"line {body[uneven][0]} has {len(values[uneven])} figures, line {body[0][0]} has "
            f"{columns}"
        )
    table = np.array(values)
    if said.nodata is not None:
        table = np.where(np.isclose(table, said.nodata, rtol=1e-6, atol=0), np.nan, table)
    if columns == 3:
        return said.grid_of_list(table)
    if columns < 3 or len(table) < 2:
        raise NotUnderstood(
            f"{len(table)} × {columns} figures are no grid of heights; "
            "a line of heights is read by brinell.trace"
        )
    return said.grid(table)


def _separator(lines: list[tuple[int, str]]) -> str:
    figures = [line for _, line in lines if re.match(r'\s*"?[-+.,\d]', line)]
    for one in ("\t", ";"):
        if any(one in line for line in figures):
            return one
    if any(re.search(r"\d[.,]?\s+[-+]?[.,]?\d", line) for line in figures):
        return ", " if any(re.search(r"\d,\s+[-+]?[.,]?\d", line) for line in figures) else " "
    return "," if any("," in line for line in figures) else " "


def _cells(line: str, separator: str) -> list[str]:
    bare = _without_sign(line)
    if separator == ", ":
        row = re.split(r",\s+|\s+", bare.strip().rstrip(","))
    elif separator == " ":
        row = re.sub(r"(?i)no data", "nodata", bare).split()
    elif '"' in bare:
        row = next(csv.reader([bare.rstrip(" \r\n")], delimiter=separator))
    else:
        row = bare.rstrip(" \r\n").split(separator)
    return [cell.strip().strip('"').strip() for cell in row]


def _is_figure(word: str) -> bool:
    plain = word.replace(",", ".")
    return word == "" or bool(HOLE.fullmatch(word) or NUMBER.fullmatch(plain))


def _is_data(row: list[str]) -> bool:
    return all(map(_is_figure, row)) and any(map(str.strip, row))


def _figures(body: list[tuple[int, list[str]]]) -> list[list[float]]:
    """Figures with a decimal point, or all with a decimal comma."""
    commas = [(number, word) for number, row in body for word in row if COMMA.fullmatch(word)]
    points = next(((number, word) for number, row in body for word in row if "." in word), None)
    if commas and points:
        raise NotUnderstood(
            f"line {commas[0][0]}: {_quoted(commas[0][1])} has a decimal comma, and "
            f"{_quoted(points[1])} in line {points[0]} a point: {DECIMAL_COMMA}"
        )
    if commas and all(AMBIGUOUS.fullmatch(word) for _, word in commas):
        word = commas[0][1]
        raise NotUnderstood(
            f"line {commas[0][0]}: {_quoted(word)} can be read as {word.replace(',', '.')} or as "
            f'{word.replace(",", "")}: {DECIMAL_COMMA}, or thousands=","'
        )
    nan = float("nan")
    if not commas:
        try:
            return [[float(word) if word else nan for word in row] for _, row in body]
        except ValueError:
            pass
    return [
        [_float(number, word.replace(",", ".")) if word else nan for word in row]
        for number, row in body
    ]


class _Header:
    """What the lines above the figures say."""

    def __init__(self) -> None:
        self.lengths: dict[str, tuple[float, str]] = {}
        self.units: dict[str, str] = {}
        self.counts: dict[str, int] = {}
        self.nodata: float | None = None
        self.columns: list[tuple[str, str]] = []
        self.notes: list[str] = []
        self.is_gwyddion = False

    def take(self, number: int, line: str, row: list[str], is_list: bool) -> None:
        """Understands a line, or raises `NotUnderstood`."""
        bare = _without_sign(line)
        bare = bare.strip().strip('"').strip()
        if not bare or not re.search(r"\w", bare):
            return
        if is_list and self._takes_columns(row):
            return
        if not is_list and len(row) > 3 and self._takes_columns(row[:3]):
            raise NotUnderstood(
                f"line {number}: {_quoted(bare)} names columns x, y, z and others: "
                "leave these three"
            )
        filled = [cell for cell in row if cell]
        key, value = (
            (filled[0], filled[1])
            if "," in line and len(filled) == 2 and not re.search("[:=]", bare)
            else _key_and_value(bare)
        )
        plain = re.sub(r"[\s._-]", "", key.lower())
        unit = re.search(r"[\[(]\s*([^\])]+?)\s*[\])]$", key)
        if unit and is_length(unit[1]):
            value = f"{value} {unit[1]}"
            plain = re.sub(r"[\s._-]", "", key[: unit.start()].lower())
        name = next((one for one, words in _KEYS.items() if plain in words), None)
        if name is None or not self._takes(name, value):
            # Words alone can say nothing of sizes.
            if not value and not re.search(r"\d", bare) and not any(map(is_length, bare.split())):
                name = "said"
            else:
                raise NotUnderstood(
                    f"line {number}: {_quoted(bare)} is not understood; if the heights do not "
                    f"depend on it: skip=[{number}]"
                )
        if name == "said":
            self.notes.append(f"line {number} ({_quoted(bare)}) left out")
        self.is_gwyddion |= name in ("width", "length") and line.lstrip().startswith("#")

    def _takes_columns(self, row: list[str]) -> bool:
        """Whether a line names the columns of a list; keeps their units."""
        if len(row) != 3:
            return False
        names = [re.sub(r"[^a-zäöü].*", "", one.lower()) for one in row]
        heights = ("z", "h", "height", "value", "höhe", "wert", "hauteur", "valeur")
        if names[0][:1] != "x" or names[1][:1] != "y" or names[2] not in heights:
            return False
        units = []
        for one in row:
            match = re.search(r"[\[(/,]?\s*([^\[(/,\s]+?)\s*[\])]?$", one)
            unit = match[1] if match else ""
            units.append(unit if is_length(unit) else "")
            if not is_length(unit) and re.search(r"[\[(]", one):
                return False
        self.columns = [(one, unit) for one, unit in zip(row, units, strict=True)]
        return True

    def _takes(self, name: str, value: str) -> bool:
        """Whether a value is one of its key; keeps it."""
        if name == "said":
            return True
        if name in ("up", "across"):
            unit = value.strip().strip("[]()")
            if not is_length(unit):
                return False
            self.units[name] = unit
            return True
        if name in ("nx", "ny"):
            if not re.fullmatch(r"\d+", value.strip()):
                return False
            self.counts[name] = int(value)
            return True
        if name == "nodata":
            word = value.strip().replace(",", ".")
            if HOLE.fullmatch(word):
                return True
            if not NUMBER.fullmatch(word):
                return False
            self.nodata = float(word)
            return True
        two = re.fullmatch(
            r"([-+\d.,e]+)\s*([^\d\sx×*;]*)(?:\s*[x×*;]\s*|\s+)([-+\d.,e]+)\s*([^\d\s]*)",
            value.strip(),
        )
        one = re.fullmatch(r"([-+\d.,e]+)\s*([^\d\s].*)?", value.strip())
        pairs = (
            [(two[1], two[2] or two[4]), (two[3], two[4] or two[2])]
            if two and name in ("extent", "spacing")
            else [(one[1], one[2] or "")] * (2 if name in ("extent", "spacing") else 1)
            if one
            else []
        )
        read = []
        for figure, unit in pairs:
            plain = figure.replace(",", ".")
            if AMBIGUOUS.fullmatch(figure) or not NUMBER.fullmatch(plain) or float(plain) <= 0:
                return False
            if unit and not is_length(unit):
                return False
            read.append((float(plain), unit))
        names = {"extent": ("width", "length"), "spacing": ("dx", "dy")}.get(name, (name,))
        if not read:
            return False
        self.lengths.update(zip(names, read, strict=True))
        return True

    def grid(self, rows: Floats) -> Grid:
        """A grid whose lines are those of the file."""
        if _counts(rows[0]) and not _counts(rows[1]):
            raise NotUnderstood("the first line counts the columns: take it out of the file")
        axes = _axes_of(rows)
        if axes and _counts(rows[0, 1:]) and _counts(rows[1:, 0]):
            raise NotUnderstood(
                "the first line and the first column count: take them out of the file"
            )
        if axes is None:
            if _counts(rows[:, 0]) and not _counts(rows[:, 1]):
                raise NotUnderstood("the first column counts the lines: take it out of the file")
            for what, one, other in (
                ("line", rows[0], rows[1]),
                ("column", rows[:, 0], rows[:, 1]),
            ):
                if len(one) > 5 and _step(one) is not None and _step(other) is None:
                    raise NotUnderstood(
                        f"the first {what} rises or falls by equal steps, and the next does not: "
                        "if it has places, take it out of the file and give the distance"
                    )
        notes = list(self.notes)
        along_x = self.is_gwyddion or bool(self.lengths) or bool(self.counts) or axes is not None
        spacing: tuple[float, float] | None = None
        if axes is not None:
            spacing = (axes[0], abs(axes[1]))
            rows = rows[1:, 1:]
            if axes[1] > 0:
                rows = rows[::-1]
            notes.append("the first line and the first column are x and y")
        if not along_x:
            notes.append("lines along y, one for each x")
            return Grid(
                rows.copy(), None, self.units.get("across", ""), self.units.get("up", ""), notes
            )
        ny, nx = rows.shape
        for name, count in (("nx", nx), ("ny", ny)):
            if self.counts.get(name, count) != count:
                raise NotUnderstood(
                    f"the head says {self.counts[name]} "
                    f"{'columns' if name == 'nx' else 'lines'}, and there are {count}"
                )
        notes.append("lines along x, the first at the largest y")
        sides = [self.lengths.get(one) for one in ("width", "length")]
        if sides == [(nx, ""), (ny, "")] and not self.units.get("across"):
            del self.lengths["width"], self.lengths["length"]
            notes.append("width and height of the head are numbers of points")
        given, across = self._spacing(nx, ny)
        if given and spacing and not np.allclose(given, spacing, rtol=1e-3):
            raise NotUnderstood(
                f"the head makes distances of {given[0]:g} and {given[1]:g}, the first line and "
                f"the first column of {spacing[0]:g} and {spacing[1]:g}"
            )
        return Grid(rows[::-1].T.copy(), given or spacing, across, self.units.get("up", ""), notes)

    def _spacing(self, nx: int, ny: int) -> tuple[tuple[float, float] | None, str]:
        """Distances of heights and their unit, as the head says them."""
        found = []
        for side, of_one, count in (("width", "dx", nx), ("length", "dy", ny)):
            if of_one in self.lengths:
                found.append(self.lengths[of_one])
                if side in self.lengths and not _agree(found[-1], self.lengths[side], count):
                    (step, a), (whole, b) = found[-1], self.lengths[side]
                    raise NotUnderstood(
                        f"the head says {count} steps of {step:g} {a} and a side of {whole:g} {b}"
                    )
            elif side in self.lengths:
                value, unit = self.lengths[side]
                found.append((value / count, unit))
        if not found:
            return None, self.units.get("across", "")
        if len(found) == 1:
            found *= 2
            self.notes.append("one distance is said, and taken for both")
        units = {unit or self.units.get("across", "") for _, unit in found}
        if len(units) == 2:
            raise NotUnderstood(f"the head has lengths in {' and in '.join(sorted(units))}")
        return (found[0][0], found[1][0]), units.pop()

    def grid_of_list(self, table: Floats) -> Grid:
        """A grid whose points are lines of x, y and z."""
        units = [unit for _, unit in self.columns] or ["", "", ""]
        across = units[0] or self.units.get("across", "")
        if units[0] != units[1]:
            raise NotUnderstood(f"x is in “{units[0]}” and y in “{units[1]}”")
        x, y, z = table.T
        if not (np.isfinite(x) & np.isfinite(y)).all():
            k = int(np.argmin(np.isfinite(x) & np.isfinite(y)))
            raise NotUnderstood(f"point {k + 1} of the list has no place")
        (i, dx, nx), (j, dy, ny) = _places(x, "x"), _places(y, "y")
        for name, count in (("nx", nx), ("ny", ny)):
            if self.counts.get(name, count) != count:
                raise NotUnderstood(
                    f"the head says {self.counts[name]} places along {name[1]}, and there are "
                    f"{count}"
                )
        at = i * ny + j
        if len(np.unique(at)) < len(at):
            raise NotUnderstood("two points of the list stand at one place")
        if nx * ny > 4 * len(z):
            raise NotUnderstood(
                f"{grouped(len(z))} points stand on no grid: they would be {nx} × {ny}; put them "
                "on one first (scipy.interpolate.griddata)"
            )
        heights = np.full((nx, ny), np.nan)
        heights[i, j] = z
        notes = [*self.notes, f"{grouped(len(z))} points x, y, z onto {nx} × {ny}"]
        return Grid(heights, (dx, dy), across, units[2] or self.units.get("up", ""), notes)


def grid_of_points(table: Floats) -> Grid:
    """Heights of points x, y and z."""
    return _Header().grid_of_list(table)


def _key_and_value(line: str) -> tuple[str, str]:
    match = re.match(r"([^:=\t;]*?)\s*[:=\t;]\s*(.*)$", line)
    if match:
        return match[1], match[2].strip().strip(";").strip().strip('"')
    match = re.match(r"(.*?\D)[\s,]+([-+]?[\d.,]+(?:e[-+]?\d+)?(?:\s*\D*)?)$", line)
    return (match[1], match[2]) if match else (line, "")


def _counts(values: Floats) -> bool:
    """Whether values are 0, 1, 2 or 1, 2, 3 and so on."""
    return bool(values[0] in (0, 1) and (values == values[0] + np.arange(len(values))).all())


def _agree(step: tuple[float, str], side: tuple[float, str], count: int) -> bool:
    """Whether so many steps, or one fewer, make a side; also where a unit is left open."""
    (one, a), (whole, b) = step, side
    if a and b:
        one, whole = one * length_in_mm(a), whole * length_in_mm(b)
    elif a or b:
        return True
    return 0.999 * (count - 1) * one <= whole <= 1.001 * count * one


def _step(of: Floats) -> float | None:
    """The step of values that rise or fall evenly."""
    steps = np.diff(of)
    even = len(of) > 2 and np.isfinite(of).all() and steps[0] != 0
    return float(steps.mean()) if even and np.ptp(steps) < 1e-3 * abs(steps.mean()) else None


def _axes_of(rows: Floats) -> tuple[float, float] | None:
    """Steps of x and y where the first line and the first column are positions."""

    x, y = _step(rows[0, 1:]), _step(rows[1:, 0])
    inner = _step(rows[1, 1:])
    return (x, y) if x is not None and y is not None and x > 0 and inner is None else None


def _places(
    values: Floats, axis: str
) -> tuple[np.ndarray[tuple[int], np.dtype[np.int64]], float, int]:
    """Number of each value among equal steps, the step and how many there are."""
    order = np.sort(values)
    steps = np.diff(order)
    extent = float(order[-1] - order[0])
    # What repeats within a millionth of the extent is one place.
    real = steps[steps > 1e-6 * extent] if extent > 0 else steps[:0]
    if not len(real):
        raise NotUnderstood(f"all points of the list have one {axis}")
    rough = float(np.median(real[real < 1.5 * real.min()]))
    step = extent / round(extent / rough)
    number = np.rint((values - order[0]) / step).astype(np.int64)
    off = np.abs((values - order[0]) / step - number)
    if off.max() > 0.05:
        raise NotUnderstood(
            f"the {axis} of the list stand at no equal steps: point {int(off.argmax()) + 1} lies "
            f"{off.max():.2f} steps beside one; put them on a grid first "
            "(scipy.interpolate.griddata)"
        )
    return number, step, int(number.max()) + 1
