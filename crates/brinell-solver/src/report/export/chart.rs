//! A chart of curves over a common abscissa, as SVG.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::ExportError;

/// Width and height of a figure \[px\].
const SIZE: (u32, u32) = (760, 460);
pub(super) const FONT: &str = "Helvetica, Arial, sans-serif";

/// Line styles of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stroke {
    Solid,
    Dashed,
}

/// A curve with its name in the legend. A curve with an empty name has no entry in the legend.
pub(super) struct Curve {
    pub name: String,
    pub points: Vec<(f64, f64)>,
    pub colour: RGBColor,
    pub stroke: Stroke,
}

/// Curves with axes.
pub(super) struct Chart {
    pub title: String,
    pub x_label: String,
    pub y_label: String,
    pub x_range: (f64, f64),
    pub y_range: (f64, f64),
    pub curves: Vec<Curve>,
    /// Whether the legend stands at the bottom instead of the top.
    pub legend_below: bool,
    /// Shaded range of the abscissa and its name.
    pub band: Option<((f64, f64), String)>,
}

impl Chart {
    /// Returns the chart as SVG.
    pub fn svg(&self) -> Result<String, ExportError> {
        let mut text = String::new();
        {
            let root = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
            self.draw(&root).map_err(|error| ExportError::Drawing(error.to_string()))?;
        }
        Ok(text)
    }

    pub(super) fn draw(
        &self,
        root: &DrawingArea<SVGBackend<'_>, plotters::coord::Shift>,
    ) -> Result<(), DrawingAreaErrorKind<std::io::Error>> {
        root.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(root)
            .margin(18)
            .caption(&self.title, (FONT, 18).into_font().color(&BLACK.mix(0.85)))
            .x_label_area_size(46)
            .y_label_area_size(68)
            .build_cartesian_2d(self.x_range.0..self.x_range.1, self.y_range.0..self.y_range.1)?;
        chart
            .configure_mesh()
            .x_desc(&self.x_label)
            .y_desc(&self.y_label)
            .axis_desc_style((FONT, 15))
            .label_style((FONT, 13))
            .x_labels(9)
            .y_labels(8)
            .x_label_formatter(&|x| short(*x))
            .y_label_formatter(&|y| short(*y))
            .bold_line_style(BLACK.mix(0.10))
            .light_line_style(TRANSPARENT)
            .axis_style(BLACK.mix(0.5))
            .draw()?;
        if let Some(((from, to), name)) = &self.band {
            let corners = [(*from, self.y_range.0), (*to, self.y_range.1)];
            chart.draw_series([Rectangle::new(
                corners,
                RGBColor(230, 159, 0).mix(0.12).filled(),
            )])?;
            let style = (FONT, 13)
                .into_font()
                .color(&RGBColor(150, 100, 0))
                .pos(Pos::new(HPos::Center, VPos::Bottom));
            let place =
                (0.5 * (from + to), self.y_range.0 + 0.02 * (self.y_range.1 - self.y_range.0));
            chart.draw_series([Text::new(name.clone(), place, style)])?;
        }
        for curve in &self.curves {
            let style = ShapeStyle::from(&curve.colour).stroke_width(2);
            let points = curve.points.iter().copied();
            let annotation = match curve.stroke {
                Stroke::Solid => chart.draw_series(LineSeries::new(points, style))?,
                Stroke::Dashed => chart.draw_series(DashedLineSeries::new(points, 7, 5, style))?,
            };
            if !curve.name.is_empty() {
                let dashed = curve.stroke == Stroke::Dashed;
                annotation.label(&curve.name).legend(move |(x, y)| {
                    let end = if dashed { x + 9 } else { x + 24 };
                    PathElement::new(vec![(x, y), (end, y)], style)
                });
            }
        }
        chart
            .configure_series_labels()
            .position(if self.legend_below {
                SeriesLabelPosition::LowerRight
            } else {
                SeriesLabelPosition::UpperRight
            })
            .background_style(WHITE.mix(0.85))
            .border_style(BLACK.mix(0.15))
            .label_font((FONT, 13))
            .draw()?;
        root.present()
    }
}

/// Returns a tick label without the rounding errors of binary fractions.
pub(super) fn short(value: f64) -> String {
    let rounded = (value * 1e6).round() / 1e6;
    format!("{}", if rounded == 0.0 { 0.0 } else { rounded })
}
