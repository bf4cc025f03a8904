"""A result in words: the verdict, remarks, then the answers of the service."""

from __future__ import annotations

import math
from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._data import ResultData
    from ._step import Answer

# Figures of a step of 0.2, which has no answers, with words and units [mm_N_MPa, SI].
ROWS = (
    ("peak_pressure", "peak pressure", ("MPa", "Pa")),
    ("half_width", "half-width", ("mm", "m")),
    ("mean_pressure", "mean pressure", ("MPa", "Pa")),
    ("approach", "approach", ("mm", "m")),
    ("force", "force", ("", "")),
    ("max_plastic_strain", "largest plastic strain", ("", "")),
    ("dent_depth", "dent", ("mm", "m")),
)
# Most steps that are shown.
SHOWN = 12


def unit_of_force(result: ResultData) -> str:
    """The unit of the contact force."""
    if result.analysis in ("axisymmetric", "three_dimensional"):
        return "N"
    return "N/m" if result.units == "SI" else "N/mm"


def _answer(answer: Answer) -> tuple[str, str, str, str, str]:
    """Name, figure, error bar, Hertz's figure and unit of an answer."""
    part = answer.quantity in ("strain", "ratio")
    factor, unit = (100.0, "%") if part else (1.0, answer.unit)
    is_known = not math.isnan(answer.value)
    shown = f"{factor * answer.value:.5g}" if is_known else "not known"
    bar = f"± {100 * answer.error:.2g} %" if answer.error > 0.0 else ""
    hertz = f"{factor * answer.elastic:.5g}" if answer.elastic > 0.0 else ""
    return (answer.label, shown, bar, hertz, unit if is_known or hertz else "")


def _lines(result: ResultData) -> list[tuple[str, str, str, str, str]]:
    """Name, figure, error bar, Hertz's figure and unit."""
    if answers := result.last.answers:
        # A force that is sought stands under its own name alone.
        is_sought = any(one.name in ("force_found", "first_yield_force") for one in answers)
        return [_answer(one) for one in answers if one.name != "force" or not is_sought]
    lines = []
    for name, words, units in ROWS:
        value = getattr(result, name)
        # After unloading, the remaining figures matter, not those under load.
        if math.isnan(value) or (value == 0.0 and result.last.unloaded):
            continue
        error = result.relative_error.get(name)
        bar = f"± {100 * error:.2g} %" if error else ""
        hertz = result.hertz.get(name)
        unit = unit_of_force(result) if name == "force" else units[result.units == "SI"]
        lines.append((words, f"{value:.5g}", bar, f"{hertz:.5g}" if hertz else "", unit))
    return lines


def _head(result: ResultData) -> str:
    steps = f", the last of {len(result.steps)} steps" if len(result.steps) > 1 else ""
    return f"{result.status.replace('_', ' ')}, {result.analysis.replace('_', ' ')}{steps}"


def text_of(result: ResultData) -> str:
    """For a terminal."""
    if result.error is not None or not result.steps:
        return f"<Result: {result.status}{f': {result.error}' if result.error else ''}>"
    remarks = [f"! {remark.code}: {remark.message}" for remark in result.remarks]
    rows = [
        f"{name:30}{value:>12} {unit:6} {bar:10}{f'Hertz {hertz}' if hertz else ''}".rstrip()
        for name, value, bar, hertz, unit in _lines(result)
    ]
    bars = ["± is the error of the mesh alone"] if result.relative_error else []
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
        "<th>mesh error</th><th>Hertz, elastic</th></tr></thead>"
        f"<tbody>{cells}</tbody></table>"
    )
    steps = _steps(result) if len(result.steps) > 1 else ""
    notes = f"<ul>{remarks}</ul>" if remarks else ""
    verdict = f"<p>{escape(result.verdict.text)}</p>" if result.verdict.text else ""
    return f"<div>{verdict}{notes}<p><b>{escape(_head(result))}</b></p>{table}{steps}</div>"


def _steps(result: ResultData) -> str:
    shown = result.steps[:SHOWN]
    names = ("force", "approach", "peak_pressure", "half_width")
    head = "".join(f"<th>{name.replace('_', ' ')}</th>" for name in ("step", *names, "status"))
    rows = "".join(
        f"<tr><td>{step.place}</td>"
        + "".join(f"<td>{getattr(step, name):.5g}</td>" for name in names)
        + f"<td>{escape(step.status)}</td></tr>"
        for step in shown
    )
    more = len(result.steps) - len(shown)
    rest = f"<p>and {more} more: see <code>summary</code></p>" if more else ""
    return f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>{rest}"
