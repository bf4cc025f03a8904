//! Filled map of the contact pressure in three dimensions, beside a chart of its two sections.

use plotters::prelude::*;

use super::ExportError;
use super::chart::{Chart, FONT, short};
use crate::report::MapsReport;

/// Width and height of the figure, and width of the map \[px\].
const SIZE: (u32, u32) = (1180, 460);
const MAP: i32 = 480;

/// Colours from zero to the largest pressure: five colours of viridis, which are distinguishable
/// with every kind of colour vision.
const COLOURS: [[f64; 3]; 5] = [
    [68.0, 1.0, 84.0],
    [59.0, 82.0, 139.0],
    [33.0, 145.0, 140.0],
    [94.0, 201.0, 98.0],
    [253.0, 231.0, 37.0],
];

/// Draws a map of cells with the peak pressure in its caption, and the chart of the sections.
pub(super) fn svg(
    maps: &MapsReport,
    caption: &str,
    length: &str,
    sections: &Chart,
) -> Result<String, ExportError> {
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        let draw = || {
            root.fill(&WHITE)?;
            let (left, right) = root.split_horizontally(MAP);
            fill(&left, maps, caption, length)?;
            sections.draw(&right)
        };
        draw().map_err(|error| ExportError::Drawing(error.to_string()))?;
    }
    Ok(text)
}

fn fill(
    area: &DrawingArea<SVGBackend<'_>, plotters::coord::Shift>,
    maps: &MapsReport,
    caption: &str,
    length: &str,
) -> Result<(), DrawingAreaErrorKind<std::io::Error>> {
    let [half_x, half_y] = [&maps.x, &maps.y].map(|middles| 0.5 * width(middles));
    let range = |middles: &[f64], half: f64| {
        let [first, last] =
            [middles.first(), middles.last()].map(|end| end.copied().unwrap_or(0.0));
        first - half..last + half
    };
    let mut chart = ChartBuilder::on(area)
        .margin(18)
        .caption(caption, (FONT, 18).into_font().color(&BLACK.mix(0.85)))
        .x_label_area_size(46)
        .y_label_area_size(68)
        .build_cartesian_2d(range(&maps.x, half_x), range(&maps.y, half_y))?;
    chart
        .configure_mesh()
        .x_desc(format!("x [{length}]"))
        .y_desc(format!("y [{length}]"))
        .axis_desc_style((FONT, 15))
        .label_style((FONT, 13))
        .x_labels(6)
        .y_labels(8)
        .x_label_formatter(&|x| short(*x))
        .y_label_formatter(&|y| short(*y))
        .disable_mesh()
        .axis_style(BLACK.mix(0.5))
        .draw()?;
    let largest = maps.pressure.iter().copied().fold(0.0, f64::max);
    let places = maps.x.iter().flat_map(|x| maps.y.iter().map(move |y| (*x, *y)));
    let pressed = places.zip(&maps.pressure).filter(|(_, pressure)| **pressure > 0.0);
    chart.draw_series(pressed.map(|((x, y), pressure)| {
        let corners = [(x - half_x, y - half_y), (x + half_x, y + half_y)];
        Rectangle::new(corners, colour(pressure / largest).filled())
    }))?;
    Ok(())
}

/// Returns the distance between the middles of neighbouring cells.
fn width(middles: &[f64]) -> f64 {
    if let [first, second, ..] = middles { second - first } else { 1.0 }
}

/// Returns the colour of a pressure, as a fraction of the largest pressure.
fn colour(part: f64) -> RGBColor {
    let place = part.clamp(0.0, 1.0) * (COLOURS.len() - 1) as f64;
    let before = (0..COLOURS.len() - 1).rev().find(|k| *k as f64 <= place).unwrap_or(0);
    let weight = place - before as f64;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between 0 and 255"
    )]
    let channel = |k: usize| {
        ((1.0 - weight) * COLOURS[before][k] + weight * COLOURS[before + 1][k])
            .round()
            .clamp(0.0, 255.0) as u8
    };
    RGBColor(channel(0), channel(1), channel(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_go_from_end_to_end() {
        assert_eq!(colour(0.0), RGBColor(68, 1, 84));
        assert_eq!(colour(0.5), RGBColor(33, 145, 140));
        assert_eq!(colour(1.0), RGBColor(253, 231, 37));
    }
}
