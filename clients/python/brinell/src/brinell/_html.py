"""A result in words: the verdict, remarks, then the answers of the service."""

from __future__ import annotations

import math
from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._data import ResultData
    from ._rows import Row

# Most steps that are shown.
SHOWN = 12


def unit_of_force(result: ResultData) -> str:
    """The unit of the contact force."""
    if result.analysis in ("axisymmetric", "three_dimensional"):
        return "N"
    return "N/m" if result.units == "SI" else "N/mm"


def _line(row: Row) -> tuple[str, str, str, str, str]:
    """Name, figure, error bar, Hertz's figure and unit."""
    factor, unit = (100.0, "%") if row.quantity in ("strain", "ratio") else (1.0, row.unit)
    is_known = not math.isnan(row.value)
    shown = f"{factor * row.value:.5g}" if is_known else "not known"
    ends = {"≥": row.at_least, "≤": row.at_most}
    bounds = [f"{sign} {factor * end:.3g}" for sign, end in ends.items() if not math.isnan(end)]
    bar = f"± {100 * row.error:.2g} %" if row.error > 0.0 else " ".join(bounds)
    hertz = f"{factor * row.elastic:.5g}" if row.elastic > 0.0 else ""
    return (row.label, shown, bar, hertz, unit if is_known or bar or hertz else "")


def _lines(result: ResultData) -> list[tuple[str, str, str, str, str]]:
    """The figures that answer the job."""
    rows = [row for row in result.answers if not row.detail]
    # A force that is sought stands under its own name alone.
    is_sought = any(row.name in ("force_found", "first_yield_force") for row in rows)
    return [_line(row) for row in rows if row.name != "force" or not is_sought]


def _head(result: ResultData) -> str:
    steps = f", the last of {len(result.steps)} steps" if len(result.steps) > 1 else ""
    return f"{result.status.replace('_', ' ')}, {result.analysis.replace('_', ' ')}{steps}"


def text_of(result: ResultData) -> str:
    """For a terminal."""
    if result.error is not None or not result.steps:
        return f"<Result: {result.status}{f': {result.error}' if result.error else ''}>"
    remarks = [f"! {remark.code}: {remark.message}" for remark in result.remarks]
    lines = _lines(result)
    width = max([30, *(len(name) + 1 for name, *_ in lines)])
    rows = [
        f"{name:{width}}{value:>12} {unit:6} {bar:10}{f'Hertz {hertz}' if hertz else ''}".rstrip()
        for name, value, bar, hertz, unit in lines
    ]
    bars = (
        ["± is the error of mesh and increments"]
        if any("±" in bar for _, _, bar, _, _ in lines)
        else []
    )
    verdict = [result.verdict.text] if result.verdict.text else []
    return "\n".join([_head(result), *verdict, *remarks, *rows, *bars])


def html_of(result: ResultData) -> str:
    """For a notebook."""
    if result.error is not None or not result.steps:
        return f"<p><b>{escape(result.status)}</b> {escape(str(result.error or ''))}</p>"
    remarks = "".join(
        f"<li><code>{escape(remark.code)}</code> {escape(remark.message)}</li>"
        for remark in result.remarks
    )
    cells = "".join(
        f"<tr><th style='text-align:left'>{escape(name)}</th><td>{value}</td>"
        f"<td>{escape(unit)}</td>"
        f"<td>{escape(bar)}</td><td>{hertz}</td></tr>"
        for name, value, bar, hertz, unit in _lines(result)
    )
    table = (
        "<table><thead><tr><th></th><th></th><th></th>"
        "<th>error</th><th>Hertz, elastic</th></tr></thead>"
        f"<tbody>{cells}</tbody></table>"
    )
    steps = _steps(result) if len(result.steps) > 1 else ""
    notes = f"<ul>{remarks}</ul>" if remarks else ""
    verdict = f"<p>{escape(result.verdict.text)}</p>" if result.verdict.text else ""
    return f"<div>{verdict}{notes}<p><b>{escape(_head(result))}</b></p>{table}{steps}</div>"


def _steps(result: ResultData) -> str:
    shown = result.steps[:SHOWN]
    columns = (
        ("force",),
        ("approach", "permanent_approach"),
        ("peak_pressure",),
        ("half_width", "semi_axis_a"),
    )
    titles = ("step", *(names[0].replace("_", " ") for names in columns), "status")
    head = "".join(f"<th>{title}</th>" for title in titles)
    rows = "".join(
        f"<tr><td>{step.place}</td>"
        + "".join(f"<td>{step.get(*names):.5g}</td>" for names in columns)
        + f"<td>{escape(step.status)}</td></tr>"
        for step in shown
    )
    more = len(result.steps) - len(shown)
    rest = f"<p>and {more} more: see <code>summary</code></p>" if more else ""
    return f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>{rest}"
