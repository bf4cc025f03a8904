//! Export of a report to tables, charts and field files. The exporters return text and write no
//! files.

mod chart;
mod csv;
mod error;
mod figures;
mod format;
mod layers_vtr;
mod map;
mod surface_vtu;
mod vtk;
mod vtu;
mod write;

pub use csv::Table;
pub use error::ExportError;
pub use figures::{depth_svg, load_approach_svg, pressure_svg, surface_svg};
pub use format::Export;
pub use layers_vtr::VtrFile;
pub use surface_vtu::surface_vtu;
pub use vtk::{VtkContents, VtkFile};
pub use vtu::{VtuFile, field_vtu};
