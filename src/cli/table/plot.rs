//! The contact pressure drawn with characters: this contact as a line, Hertz as dots. That of a
//! body of revolution is drawn over the radius, from the axis on; that in three dimensions over x
//! and over y.

use std::fmt::Write;

use super::number::{round_up, short};
use super::text::{Names, WIDTH};
use crate::cli::style::Style;
use brinell_solver::report::{Name, StepReport};

/// Size of the picture in characters; each is 2 × 4 dots.
const COLUMNS: usize = 64;
const ROWS: usize = 12;
const DOTS_X: usize = 2 * COLUMNS;
const DOTS_Y: usize = 4 * ROWS;
/// Width of the numbers beside the picture.
const LABEL: usize = 9;
/// Distance, in dots, between the dots of Hertz's curve.
const DOTTED: f64 = 3.0;

/// Two bits of every character: which of its dots belong to which curve.
#[derive(Debug, Clone, Copy, Default)]
struct Cell {
    contact: u8,
    hertz: u8,
}

/// A line across the contact: places, pressures, and what Hertz says of it.
struct Section<'a> {
    x: &'a [f64],
    pressure: &'a [f64],
    hertz: Option<Ellipse>,
    abscissa: &'static str,
}

/// Hertz's pressure along a section.
#[derive(Debug, Clone, Copy)]
struct Ellipse {
    half_width: f64,
    peak_pressure: f64,
}

/// The pictures of a step with their axes, one below the other; empty when there is nothing to
/// draw.
pub(super) fn pressure(step: &StepReport, names: Names, style: Style) -> String {
    let elastic = |name: Name| step.row(name).and_then(|row| row.elastic);
    let shorter = elastic(Name::HalfWidth).or(elastic(Name::SemiAxisA));
    let hertz = shorter.zip(elastic(Name::PeakPressure));
    let hertz = hertz.map(|(half_width, peak_pressure)| Ellipse { half_width, peak_pressure });
    let nodes = &step.contact.nodes;
    let mut sections = vec![Section {
        x: &nodes.x,
        pressure: &nodes.pressure,
        hertz,
        abscissa: names.abscissa(),
    }];
    if let Some(section) = &step.contact.section {
        let longer = elastic(Name::SemiAxisB).filter(|_| step.contact.along.is_none());
        let hertz = hertz.zip(longer);
        let hertz = hertz.map(|(hertz, half_width)| Ellipse { half_width, ..hertz });
        sections.push(Section {
            x: &section.y,
            pressure: &section.pressure,
            hertz,
            abscissa: "y",
        });
    }
    let pressures = nodes.pressure.iter().copied();
    let peak = pressures.chain(hertz.map(|hertz| hertz.peak_pressure)).fold(0.0, f64::max);
    let pictures: Vec<String> = sections
        .iter()
        .map(|section| picture(section, peak, names, style))
        .filter(|picture| !picture.is_empty())
        .collect();
    pictures.join("\n")
}

fn picture(section: &Section<'_>, peak: f64, names: Names, style: Style) -> String {
    let hertz = section.hertz;
    let pressed = section.x.iter().zip(section.pressure).filter(|(_, p)| **p > 0.0);
    let reach =
        pressed.map(|(x, _)| x.abs()).fold(hertz.map_or(0.0, |hertz| hertz.half_width), f64::max);
    if peak <= 0.0 || reach <= 0.0 {
        return String::new();
    }
    let (top, edge) = (round_up(peak), round_up(1.1 * reach));
    let mut cells = [[Cell::default(); COLUMNS]; ROWS];
    let scale = Scale { left: if names.is_round { 0.0 } else { -edge }, right: edge, top };
    if let Some(hertz) = hertz {
        dot_ellipse(&mut cells, hertz, scale);
    }
    // Of a body of revolution the curve goes on beyond the axis.
    let mut before =
        if names.is_round { level(interpolated(section, scale.x(0)), top) } else { None };
    for column in 0..DOTS_X {
        let here = level(interpolated(section, scale.x(column)), top);
        for level in stroke(before, here) {
            let (row, bit) = dot(column, level);
            cells[row][column / 2].contact |= bit;
        }
        before = here;
    }
    framed(&cells, scale, section, names, style)
}

/// What the picture shows.
#[derive(Debug, Clone, Copy)]
struct Scale {
    left: f64,
    right: f64,
    top: f64,
}

impl Scale {
    /// Dots over a length.
    fn dots_x(self) -> f64 {
        DOTS_X as f64 / (self.right - self.left)
    }

    /// The middle of a column of dots.
    fn x(self, column: usize) -> f64 {
        self.left + (column as f64 + 0.5) / self.dots_x()
    }
}

/// Hertz's ellipse, `p = p0 sin θ` at `x = -a cos θ`, dotted evenly along the curve.
fn dot_ellipse(cells: &mut [[Cell; COLUMNS]; ROWS], hertz: Ellipse, scale: Scale) {
    let scale_y = DOTS_Y as f64 / scale.top;
    let mut angle = if scale.left < 0.0 { 0.0 } else { std::f64::consts::FRAC_PI_2 };
    while angle < std::f64::consts::PI {
        let (sine, cosine) = angle.sin_cos();
        if let Some(level) = level(hertz.peak_pressure * sine, scale.top) {
            let column =
                ((-hertz.half_width * cosine - scale.left) * scale.dots_x()).floor().max(0.0);
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "clamped to the picture"
            )]
            let column = (column as usize).min(DOTS_X - 1);
            let (row, bit) = dot(column, level);
            cells[row][column / 2].hertz |= bit;
        }
        let along_x = hertz.half_width * sine * scale.dots_x();
        let along_y = hertz.peak_pressure * cosine * scale_y;
        angle += DOTTED / along_x.hypot(along_y).max(1.0);
    }
}

/// Pressure at x, linear between nodes and zero beyond them.
fn interpolated(nodes: &Section<'_>, x: f64) -> f64 {
    let right = nodes.x.partition_point(|node| *node < x);
    let (Some(&x_right), Some(&p_right)) = (nodes.x.get(right), nodes.pressure.get(right)) else {
        return 0.0;
    };
    let Some(left) = right.checked_sub(1) else { return 0.0 };
    let (x_left, p_left) = (nodes.x[left], nodes.pressure[left]);
    p_left + (p_right - p_left) * (x - x_left) / (x_right - x_left)
}

/// Height of a pressure in dots above the axis; none for no pressure.
fn level(pressure: f64, top: f64) -> Option<usize> {
    let height = (pressure / top * DOTS_Y as f64).floor();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped to the picture"
    )]
    (pressure > 0.0).then(|| height.clamp(0.0, (DOTS_Y - 1) as f64) as usize)
}

/// The dots of one column that join this height to the one before, so that steep curves do not
/// break.
fn stroke(before: Option<usize>, here: Option<usize>) -> std::ops::Range<usize> {
    match (before, here) {
        (Some(before), Some(here)) if here > before => before + 1..here + 1,
        (Some(before), Some(here)) if here < before => here..before,
        (_, Some(here)) if before.is_none() => 0..here + 1,
        (_, Some(here)) => here..here + 1,
        (Some(before), None) => 0..before,
        (None, None) => 0..0,
    }
}

/// Row of characters and bit of the braille pattern of a dot.
fn dot(column: usize, level: usize) -> (usize, u8) {
    const BITS: [[u8; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];
    let from_top = DOTS_Y - 1 - level.min(DOTS_Y - 1);
    (from_top / 4, BITS[from_top % 4][column % 2])
}

fn framed(
    cells: &[[Cell; COLUMNS]; ROWS],
    scale: Scale,
    section: &Section<'_>,
    names: Names,
    style: Style,
) -> String {
    let legend = if section.hertz.is_some() { "line: this contact, dots: Hertz" } else { "" };
    let head = format!("[{}] {legend}", names.stress);
    let mut text = format!("{:>LABEL$}  {}\n", "pressure", style.dim(head.trim_end()));
    for (row, cells) in cells.iter().enumerate() {
        let label = match row {
            0 => short(scale.top),
            row if row == ROWS / 2 => short(0.5 * scale.top),
            _ => String::new(),
        };
        let axis = if label.is_empty() { '│' } else { '┤' };
        let line = drawn(cells, style);
        text.push_str(format!("{label:>LABEL$} {axis}{line}").trim_end());
        text.push('\n');
    }
    let quarter = "─".repeat(COLUMNS / 4 - 1);
    let axis = format!("└{quarter}┴{quarter}┴{quarter}┴{quarter}┴");
    let _ = writeln!(text, "{:>LABEL$} {axis}", "0");
    text.push_str(&x_labels(scale, section.abscissa, names));
    text
}

fn x_labels(scale: Scale, abscissa: &str, names: Names) -> String {
    let mut text = " ".repeat(LABEL + 1);
    for quarter in 0..=4 {
        let x = scale.left + 0.25 * f64::from(quarter) * (scale.right - scale.left);
        let label = short(x);
        let label = if x == 0.0 { format!("{abscissa} = 0 {}", names.length) } else { label };
        let middle = LABEL + 1 + COLUMNS / 4 * usize::try_from(quarter).unwrap_or(0);
        let start = middle.saturating_sub(label.len() / 2).min(WIDTH - label.len());
        let pad = start.saturating_sub(text.len());
        text.push_str(&" ".repeat(pad));
        text.push_str(&label);
    }
    text.push('\n');
    text
}

/// One row of characters, neighbours of one colour painted together.
fn drawn(cells: &[Cell], style: Style) -> String {
    let is_contact = |cell: &Cell| cell.contact != 0;
    let is_blank = |cell: &Cell| cell.contact | cell.hertz == 0;
    let last = cells.iter().rposition(|cell| !is_blank(cell)).map_or(0, |last| last + 1);
    let runs = cells[..last].chunk_by(|one, other| is_contact(one) == is_contact(other));
    let paint = |run: &[Cell]| {
        let text: String = run.iter().map(|cell| symbol(*cell, style)).collect();
        if is_contact(&run[0]) { style.cyan(&text) } else { style.dim(&text) }
    };
    runs.map(paint).collect()
}

fn symbol(cell: Cell, style: Style) -> char {
    match (style.unicode, cell.contact, cell.hertz) {
        (_, 0, 0) => ' ',
        (true, contact, hertz) => {
            char::from_u32(0x2800 + u32::from(contact | hertz)).unwrap_or('?')
        }
        (false, 0, _) => '.',
        (false, _, _) => '*',
    }
}
