//! VTK file of the fields of both bodies on unstructured cells.
//!
//! ```text
//! image of a half model:  x → -x,  u_x → -u_x,  τ_xy → -τ_xy
//!                         corners in reverse order (still counter-clockwise)
//! upper body:             u_y → u_y - α, so that the support of the lower body is at rest
//! ```
//!
//! Both halves share the nodes on the axis. For a body of revolution x is the radius, and there is
//! no image.

use std::ops::Range;

use super::ExportError;
use super::surface_vtu::surface_vtu;
use super::vtk::Type::{Float64, Int64, UInt8};
use super::vtk::{
    Array, Encoding, Places, QUAD, Sources, Values, VtkContents, VtkFile, places, unusable,
};
use crate::job::{Analysis, Named};
use crate::report::field_arrays::CHUNK;
use crate::report::{FieldLayout, Report, Side, encode_fields};

/// Writes the mesh before loading with `displacement` \[length\], `stress` (XX, YY, ZZ, XY, YZ,
/// XZ), `von_mises` and `equivalent_plastic_strain` at its nodes and `body` (0 lower, 1 upper) in
/// its cells, in the units of the job.
///
/// Displacements are relative to the support of the lower body: the upper body moves down by the
/// approach, so that the displaced bodies touch. Load steps are counted from 0.
///
/// # Errors
/// [`ExportError::NoStep`]; [`ExportError::NoFields`] if the job did not ask for fields.
pub fn field_vtu(report: &Report, step: usize) -> Result<String, ExportError> {
    let shown = report.steps.get(step).ok_or(ExportError::NoStep(step))?;
    let place = [step, report.steps.len()];
    if shown.contact.section.is_some() {
        let maps = shown.contact.maps.as_ref().ok_or(ExportError::NoFields)?;
        return Ok(surface_vtu(report, place, maps.clone()).collect());
    }
    let fields = shown.fields.as_ref().ok_or(ExportError::NoFields)?;
    let bytes = encode_fields(fields).map_err(unusable)?;
    let layout = FieldLayout::read(&bytes).map_err(unusable)?;
    let approach = shown.approach().unwrap_or_default();
    Ok(VtuFile::new(report, place, approach, &layout)?.whole(&bytes))
}

/// A file of fields.
pub type VtuFile = VtkFile<Meshes>;

/// The meshes of the deformable bodies, the lower one first.
#[derive(Debug)]
pub struct Meshes(Vec<Body>);

/// A deformable body.
#[derive(Debug)]
struct Body {
    name: u8,
    is_half: bool,
    /// Distance by which the body moves down \[length\].
    descent: f64,
    nodes: usize,
    elements: usize,
    places: Places,
    /// Nodes on the axis of a half model, in ascending order.
    axis: Vec<usize>,
}

/// Some of the nodes or elements of a body, or of its image.
#[derive(Debug, Clone)]
pub struct Items {
    body: usize,
    is_image: bool,
    range: Range<usize>,
}

impl Body {
    fn new(
        name: u8,
        layout: &FieldLayout,
        is_half: bool,
        descent: f64,
    ) -> Result<Option<Self>, ExportError> {
        let side = if name == 0 { Side::Lower } else { Side::Upper };
        if !layout.has(side) {
            return Ok(None);
        }
        let places = places::<Meshes>(layout, side)?;
        let [nodes, elements] = ["von_mises", "elements"].map(|name| places[name].len());
        let (nodes, elements) = (nodes / size_of::<f64>(), elements / size_of::<[u32; 4]>());
        Ok(Some(Self { name, is_half, descent, nodes, elements, places, axis: Vec::new() }))
    }

    /// Returns the number of nodes, including the image.
    fn all_nodes(&self) -> usize {
        if self.is_half { 2 * self.nodes - self.axis.len() } else { self.nodes }
    }

    /// Returns the index of a node, or of its image, among the nodes of the body and its image.
    fn index(&self, node: usize, is_image: bool) -> usize {
        match self.axis.binary_search(&node) {
            Err(before) if is_image => (self.nodes + node).saturating_sub(before),
            _ => node,
        }
    }

    /// Returns the positions of the sources of some of `count` nodes or elements.
    fn sources(&self, names: &[&str], range: &Range<usize>, count: usize) -> Vec<Range<usize>> {
        let of = |name: &&str| {
            let (begin, bytes) = (self.places[name].start, self.places[name].len() / count);
            begin + bytes * range.start..begin + bytes * range.end
        };
        names.iter().map(of).collect()
    }

    fn blocks(&self, names: &[&str], count: usize, body: usize, is_image: bool) -> Blocks {
        let block = |from: usize| {
            let range = from..(from + CHUNK).min(count);
            let sources = self.sources(names, &range, count);
            (Items { body, is_image, range }, sources)
        };
        (0..count).step_by(CHUNK).map(block).collect()
    }
}

type Blocks = Vec<(Items, Vec<Range<usize>>)>;

impl VtuFile {
    /// Returns the file of the load step `step`, counted from 0 and out of `steps`, with its
    /// approach and with the fields in `layout`.
    ///
    /// # Errors
    /// [`ExportError::Fields`].
    pub fn new(
        report: &Report,
        [step, steps]: [usize; 2],
        approach: f64,
        layout: &FieldLayout,
    ) -> Result<Self, ExportError> {
        let is_half = report.mesh.symmetric && report.analysis != Analysis::Axisymmetric.name();
        let bodies = [(0, 0.0), (1, approach)]
            .map(|(name, descent)| Body::new(name, layout, is_half, descent));
        let bodies: Result<_, _> = bodies.into_iter().filter_map(Result::transpose).collect();
        Ok(Self::of(report, [step, steps], Meshes(bodies?)))
    }
}

impl Meshes {
    fn n_nodes(&self) -> usize {
        self.before(self.0.len())[0]
    }

    fn n_elements(&self) -> usize {
        self.before(self.0.len())[1]
    }

    /// Returns the numbers of nodes and elements in the bodies before `body`, including their
    /// images.
    fn before(&self, body: usize) -> [usize; 2] {
        let bodies = self.0.iter().take(body);
        let count =
            |body: &Body| [body.all_nodes(), body.elements * (1 + usize::from(body.is_half))];
        bodies.map(count).fold([0; 2], |[n, e], [nodes, elements]| [n + nodes, e + elements])
    }

    /// Writes the values at nodes from the place of a node among them and the sign of the image.
    fn at_nodes<const N: usize>(
        &self,
        items: &Items,
        values: &mut Values,
        value: impl Fn(usize, f64) -> [f64; N],
    ) {
        let (axis, sign) = (&self.0[items.body].axis, if items.is_image { -1.0 } else { 1.0 });
        let is_written = |node: &usize| !items.is_image || axis.binary_search(node).is_err();
        let nodes = items.range.clone().enumerate().filter(|(_, node)| is_written(node));
        values.floats(nodes.flat_map(|(k, _)| value(k, sign)));
    }

    fn scalar(&self, items: &Items, from: Sources, values: &mut Values) {
        self.at_nodes(items, values, |k, _| [from.float(0, k)]);
    }

    fn displacement(&self, items: &Items, from: Sources, values: &mut Values) {
        let descent = self.0[items.body].descent;
        self.at_nodes(items, values, |k, sign| {
            [sign * from.float(0, 2 * k), from.float(0, 2 * k + 1) - descent, 0.0]
        });
    }

    fn stress(&self, items: &Items, from: Sources, values: &mut Values) {
        self.at_nodes(items, values, |k, sign| {
            let [xx, yy, zz, xy] = [0, 1, 2, 3].map(|source| from.float(source, k));
            [xx, yy, zz, sign * xy, 0.0, 0.0]
        });
    }

    fn points(&self, items: &Items, from: Sources, values: &mut Values) {
        self.at_nodes(items, values, |k, sign| {
            [sign * from.float(0, 2 * k), from.float(0, 2 * k + 1), 0.0]
        });
    }

    fn corners(&self, items: &Items, from: Sources, values: &mut Values) {
        let (body, [first, _]) = (&self.0[items.body], self.before(items.body));
        let corners = from.0.first().map_or(&[][..], |bytes| bytes.as_chunks::<16>().0);
        values.integers(corners.iter().flat_map(|corners| {
            let corner = |k: usize| corners.as_chunks().0[if items.is_image { 3 - k } else { k }];
            let node = |k| body.index(u32::from_le_bytes(corner(k)) as usize, items.is_image);
            [0, 1, 2, 3].map(|k| first + node(k))
        }));
    }

    fn offsets(&self, items: &Items, _: Sources, values: &mut Values) {
        let [_, before] = self.before(items.body);
        let first = before + if items.is_image { self.0[items.body].elements } else { 0 };
        values.integers(items.range.clone().map(|k| 4 * (first + k + 1)));
    }
}

const NODES: &str = "PointData Scalars=\"von_mises\" Vectors=\"displacement\"";
const STRESS: &[&str] = &["sigma_x", "sigma_y", "sigma_z", "tau_xy"];
const MOVED: &str = "displacement";
const JOINED: &str = "connectivity";
const STRAIN: &str = "equivalent_plastic_strain";

impl VtkContents for Meshes {
    type Block = Items;

    const GRID: &'static str = "UnstructuredGrid";
    const ENCODING: Encoding = Encoding::Base64;
    const ARRAYS: &'static [Array<Self>] = &[
        Array(NODES, Float64, MOVED, 3, Self::n_nodes, &[MOVED], Self::displacement),
        Array(NODES, Float64, "stress", 6, Self::n_nodes, STRESS, Self::stress),
        Array(NODES, Float64, "von_mises", 1, Self::n_nodes, &["von_mises"], Self::scalar),
        Array(NODES, Float64, STRAIN, 1, Self::n_nodes, &[STRAIN], Self::scalar),
        Array("CellData", UInt8, "body", 1, Self::n_elements, &[], |all, items, _, values| {
            values.repeated(all.0[items.body].name, items.range.len());
        }),
        Array("Points", Float64, "Points", 3, Self::n_nodes, &["nodes"], Self::points),
        Array("Cells", Int64, JOINED, 1, |all| 4 * all.n_elements(), &["elements"], Self::corners),
        Array("Cells", Int64, "offsets", 1, Self::n_elements, &[], Self::offsets),
        Array("Cells", UInt8, "types", 1, Self::n_elements, &[], |_, items, _, values| {
            values.repeated(QUAD, items.range.len());
        }),
    ];

    fn size(&self) -> [String; 2] {
        let (points, cells) = (self.n_nodes(), self.n_elements());
        [String::new(), format!("NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\"")]
    }

    /// Finds the nodes on the axis.
    fn survey(&self) -> Blocks {
        let halves = self.0.iter().enumerate().filter(|(_, body)| body.is_half);
        halves.flat_map(|(k, body)| body.blocks(&["nodes"], body.nodes, k, false)).collect()
    }

    fn read(&mut self, items: &Items, from: Sources) {
        let nodes = items.range.clone().enumerate();
        let on_axis = nodes.filter(|(k, _)| from.float(0, 2 * k) == 0.0).map(|(_, node)| node);
        self.0[items.body].axis.extend(on_axis);
    }

    fn blocks(&self, array: &Array<Self>) -> Blocks {
        let is_of_cells = array.0.starts_with("Cell");
        let bodies = self.0.iter().enumerate().flat_map(|(k, body)| {
            let count = if is_of_cells { body.elements } else { body.nodes };
            let images = [false, true].into_iter().take(1 + usize::from(body.is_half));
            images.flat_map(move |is_image| body.blocks(array.5, count, k, is_image))
        });
        bodies.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::{FieldsReport, PerBody};

    #[test]
    fn a_half_is_completed_by_its_image() {
        let square = FieldsReport {
            nodes: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            elements: vec![[0, 1, 2, 3]],
            displacement: vec![[0.5, -1.0]; 4],
            sigma_x: vec![1.0; 4],
            sigma_y: vec![2.0; 4],
            sigma_z: vec![3.0; 4],
            tau_xy: vec![4.0; 4],
            von_mises: vec![5.0; 4],
            equivalent_plastic_strain: vec![6.0; 4],
        };
        let bytes =
            encode_fields(&PerBody { upper: Some(square.clone()), lower: Some(square) }).unwrap();
        let layout = FieldLayout::read(&bytes).unwrap();
        let mut bodies =
            [0, 1].map(|name| Body::new(name, &layout, name == 0, 0.25).unwrap().unwrap());
        bodies[0].axis = vec![0, 3];
        let meshes = Meshes(bodies.into());
        assert_eq!(meshes.before(2), [6 + 4, 3]);
        let written = |name: &str, body: usize, is_image, range: Range<usize>| {
            let array = Meshes::ARRAYS.iter().find(|array| array.2 == name).unwrap();
            let count = if array.0.starts_with("Cell") { 1 } else { 4 };
            let places = meshes.0[body].sources(array.5, &range, count);
            let sources: Vec<_> = places.into_iter().map(|place| &bytes[place]).collect();
            let mut values = Values::new(Encoding::Base64);
            let items = Items { body, is_image, range };
            array.6(&meshes, &items, Sources(&sources), &mut values);
            values.pending
        };
        let integers = |bytes: Vec<u8>| {
            bytes.as_chunks::<8>().0.iter().map(|b| u64::from_le_bytes(*b)).collect::<Vec<_>>()
        };
        let floats = |bytes: Vec<u8>| {
            bytes.as_chunks::<8>().0.iter().map(|b| f64::from_le_bytes(*b)).collect::<Vec<_>>()
        };
        assert_eq!(integers(written("connectivity", 0, false, 0..1)), [0, 1, 2, 3]);
        assert_eq!(integers(written("connectivity", 0, true, 0..1)), [3, 5, 4, 0]);
        assert_eq!(integers(written("connectivity", 1, false, 0..1)), [6, 7, 8, 9]);
        assert_eq!(integers(written("offsets", 1, false, 0..1)), [12]);
        assert_eq!(floats(written("Points", 0, true, 0..2)), [-1.0, 0.0, 0.0]);
        assert_eq!(floats(written("displacement", 0, true, 1..2)), [-0.5, -1.25, 0.0]);
        assert_eq!(floats(written("stress", 0, true, 2..4)), [1.0, 2.0, 3.0, -4.0, 0.0, 0.0]);
        assert_eq!(written("body", 1, false, 0..1), [1]);
    }
}
