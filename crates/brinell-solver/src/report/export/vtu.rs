//! The fields of both bodies as a VTK file of unstructured cells, for ParaView and the like.
//!
//! Arrays are inline: base64 of a 64-bit count of bytes and the little-endian values behind it.
//!
//! # Reference
//! *VTK XML file formats*, <https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html>.

use std::fmt::{Display, Write as _};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::ExportError;
use super::section::{Node, Section};
use crate::report::Report;

/// VTK's number for a quadrilateral with 4 nodes.
const QUAD: u8 = 9;

/// The mesh before loading with `displacement` \[length\], `stress` (XX, YY, ZZ, XY, YZ, XZ), `von_mises` and
/// `equivalent_plastic_strain` at its nodes and `body` (0 lower, 1 upper) in its cells, in the units of the job.
///
/// Half models are completed; of a body of revolution it is the half section, x being the radius and zz the hoop
/// direction. Displacements are those relative to the support of the lower body: the upper one comes down by the
/// approach, so that the bodies touch once displaced. Steps are counted from 0.
///
/// # Errors
/// [`ExportError::NoStep`]; [`ExportError::NoFields`] where the job did not ask for them.
pub fn field_vtu(report: &Report, step: usize) -> Result<String, ExportError> {
    let section = Section::of(report, step)?;
    let (nodes, elements) = (&section.nodes, &section.elements);
    let mut text = String::with_capacity(200 * nodes.len() + 60 * elements.len() + 2000);
    let _ = write!(
        text,
        "<?xml version=\"1.0\"?>\n\
         <!-- brinell {}, {}, units {}, step {} of {} -->\n\
         <VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
         <UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
        report.version,
        report.analysis,
        report.units,
        step + 1,
        report.steps.len(),
        nodes.len(),
        elements.len(),
    );
    text.push_str("<PointData Scalars=\"von_mises\" Vectors=\"displacement\">\n");
    floats(&mut text, "displacement", "NumberOfComponents=\"3\"", nodes.iter().flat_map(displacement));
    floats(&mut text, "stress", STRESS_COMPONENTS, nodes.iter().flat_map(stress));
    floats(&mut text, "von_mises", "", nodes.iter().map(|node| node.von_mises));
    let strains = nodes.iter().map(|node| node.equivalent_plastic_strain);
    floats(&mut text, "equivalent_plastic_strain", "", strains);
    text.push_str("</PointData>\n<CellData>\n");
    array(&mut text, "UInt8", "body", "", &section.body);
    text.push_str("</CellData>\n<Points>\n");
    let positions = nodes.iter().flat_map(|Node { position: [x, y], .. }| [*x, *y, 0.0]);
    floats(&mut text, "Points", "NumberOfComponents=\"3\"", positions);
    text.push_str("</Points>\n<Cells>\n");
    integers(&mut text, "connectivity", elements.iter().flatten().map(|node| u64::from(*node)));
    integers(&mut text, "offsets", (4u64..).step_by(4).take(elements.len()));
    array(&mut text, "UInt8", "types", "", &vec![QUAD; elements.len()]);
    text.push_str("</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    Ok(text)
}

const STRESS_COMPONENTS: &str = "NumberOfComponents=\"6\" ComponentName0=\"XX\" ComponentName1=\"YY\" \
     ComponentName2=\"ZZ\" ComponentName3=\"XY\" ComponentName4=\"YZ\" ComponentName5=\"XZ\"";

fn displacement(node: &Node) -> [f64; 3] {
    let [u_x, u_y] = node.displacement;
    [u_x, u_y, 0.0]
}

fn stress(node: &Node) -> [f64; 6] {
    let [s_x, s_y, s_z, t_xy] = node.stress;
    [s_x, s_y, s_z, t_xy, 0.0, 0.0]
}

fn floats(text: &mut String, name: &str, attributes: &str, values: impl Iterator<Item = f64>) {
    let bytes: Vec<u8> = values.flat_map(f64::to_le_bytes).collect();
    array(text, "Float64", name, attributes, &bytes);
}

fn integers(text: &mut String, name: &str, values: impl Iterator<Item = u64>) {
    let bytes: Vec<u8> = values.flat_map(u64::to_le_bytes).collect();
    array(text, "Int64", name, "", &bytes);
}

fn array(text: &mut String, kind: impl Display, name: &str, attributes: &str, bytes: &[u8]) {
    let _ = write!(text, "<DataArray type=\"{kind}\" Name=\"{name}\" {attributes} format=\"binary\">");
    let header = (bytes.len() as u64).to_le_bytes();
    STANDARD.encode_string([&header, bytes].concat(), text);
    text.push_str("</DataArray>\n");
}
