//! A report in forms that other programs and people read. Nothing here writes to a disk: exporters return text.

mod chart;
mod csv;
mod figures;

pub use csv::{pressure_csv, subsurface_csv};
pub use figures::{FigureError, depth_svg, pressure_svg};
