//! Measured or computed heights on a grid, on top of the shape of a half-space. They exist only in
//! three dimensions.

use serde::Serialize;
use serde::ser::{SerializeStruct, Serializer};
use strum::{IntoStaticStr, VariantArray};

use super::fields::InUnits;
use super::reader::Cursor;
use super::{Domain, FaultCode, Named, NoData, Units, no_data, npy};

/// Heights over the shape of a body at the middles of equal cells, along the outward normal.
/// Lengths in mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// Heights, `[i * cells[1] + j]` at the i-th x and the j-th y.
    heights: Vec<f64>,
    cells: [usize; 2],
    spacing: [f64; 2],
    detrend: Detrend,
    /// Heights of exactly one value among others that differ.
    block: Option<NoData>,
}

/// The trend that is subtracted from heights.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "snake_case")]
pub enum Detrend {
    /// No trend.
    #[default]
    None,
    /// The least-squares plane.
    Plane,
}

impl Named for Detrend {}

impl Surface {
    /// The key of heights in a body.
    pub const KEY: &'static str = "surface";
    pub(super) const KEYS: &'static [&'static str] =
        &["heights", "spacing_x", "spacing_y", "detrend"];
    /// The key of heights as a numpy array.
    pub const NPY: &'static str = "npy_base64";
    /// Least number of cells along a side.
    pub const MIN_CELLS: usize = 8;
    /// Largest number of cells along a side, of elastic bodies.
    pub const MAX_CELLS: usize = 1024;
    /// Largest number of cells along a side where a body yields: layers below the cells are kept.
    pub const MAX_CELLS_OF_YIELD: usize = 512;

    /// Returns the number of cells along x and y.
    pub const fn cells(&self) -> [usize; 2] {
        self.cells
    }

    /// Returns the sides of a cell along x and y \[mm\].
    pub const fn spacing(&self) -> [f64; 2] {
        self.spacing
    }

    /// Returns the heights of exactly one value among others that all differ.
    pub(crate) const fn block(&self) -> Option<&NoData> {
        self.block.as_ref()
    }

    /// Whether both surfaces have their heights at the same points.
    pub(super) fn has_cells_of(&self, other: &Self) -> bool {
        let bits = |surface: &Self| surface.spacing.map(f64::to_bits);
        self.cells == other.cells && bits(self) == bits(other)
    }

    /// Returns the heights less their trend, in the order `[i * cells[1] + j]` \[mm\].
    pub fn levelled(&self) -> Vec<f64> {
        let [nx, ny] = self.cells;
        if self.detrend == Detrend::None {
            return self.heights.clone();
        }
        // Cell numbers relative to the middle, so that the sum of x y is zero.
        let centred = |k: usize, n: usize| k as f64 - 0.5 * (n - 1) as f64;
        let mean = self.heights.iter().sum::<f64>() / self.heights.len() as f64;
        let slope = |at: &dyn Fn(usize) -> f64| {
            let all = self.heights.iter().enumerate();
            let (product, square) = all
                .fold((0.0, 0.0), |(p, s), (k, height)| (p + at(k) * height, s + at(k) * at(k)));
            product / square
        };
        let (x, y) = (|k: usize| centred(k / ny, nx), |k: usize| centred(k % ny, ny));
        let slopes = [slope(&x), slope(&y)];
        let levelled =
            |(k, height): (usize, &f64)| height - mean - slopes[0] * x(k) - slopes[1] * y(k);
        self.heights.iter().enumerate().map(levelled).collect()
    }

    /// Reads heights from lists. Returns them with their numbers along x and y.
    fn read_rows(c: Cursor<'_>, units: Option<Units>) -> Option<([usize; 2], Vec<f64>)> {
        let counts = Self::MIN_CELLS..=Self::MAX_CELLS;
        let row = |row: Cursor<'_>| {
            row.array(counts.clone(), |c| c.quantity::<f64>(Domain::Position, units))
        };
        let rows: Vec<Vec<f64>> = c.array(counts.clone(), row)?;
        if rows.iter().any(|row| row.len() != rows[0].len()) {
            c.fault(
                FaultCode::Inconsistent,
                format_args!("every row must have as many heights as the first"),
            );
            return None;
        }
        Some(([rows.len(), rows[0].len()], rows.concat()))
    }

    /// Reads heights from a numpy array. Returns them with their numbers along x and y.
    fn read_npy(c: Cursor<'_>, units: Option<Units>) -> Option<([usize; 2], Vec<f64>)> {
        let object = c.object()?;
        object.only(&[Self::NPY]);
        object.required(Self::NPY, |c| {
            let fault = |detail: String| {
                c.fault(FaultCode::Inconsistent, format_args!("{detail}"));
                None
            };
            let npy::Grid { shape, mut values } =
                match npy::read(c.text()?, Self::MAX_CELLS * Self::MAX_CELLS) {
                    Ok(grid) => grid,
                    Err(detail) => return fault(detail),
                };
            let (fewest, most) = (Self::MIN_CELLS, Self::MAX_CELLS);
            if !shape.iter().all(|side| (fewest..=most).contains(side)) {
                let [rows, columns] = shape;
                return fault(format!(
                    "must have between {fewest} and {most} heights along each side, got {rows} × \
                     {columns}"
                ));
            }
            let units = units?;
            let (low, high) = Domain::Position.wire_range(units);
            if let Some(k) = values.iter().position(|value| !(low..=high).contains(value)) {
                let (i, j, unit) = (k / shape[1], k % shape[1], Domain::Position.symbol(units));
                return fault(format!(
                    "must have heights between {low} and {high} {unit}, got {} at [{i}, {j}]",
                    values[k]
                ));
            }
            for value in &mut values {
                *value = Domain::Position.to_core(units, *value);
            }
            Some((shape, values))
        })
    }

    pub(super) fn read(cursor: Cursor<'_>, units: Option<Units>) -> Option<Self> {
        let object = cursor.object()?;
        object.only(Self::KEYS);
        let rows = object.required("heights", |c| {
            let rows =
                if c.is_object() { Self::read_npy(c, units) } else { Self::read_rows(c, units) };
            rows.filter(|(cells, heights)| {
                units.is_none_or(|u| is_all_data(c, *cells, heights, u))
            })
        });
        let spacing = |key| object.required(key, |c| c.quantity::<f64>(Domain::Length, units));
        let (spacing_x, spacing_y) = (spacing("spacing_x"), spacing("spacing_y"));
        let detrend = object.or("detrend", Detrend::default(), |c| c.named());
        let (cells, heights) = rows?;
        let block = no_data::of_one_value(&heights, cells[1]);
        Some(Self { cells, heights, spacing: [spacing_x?, spacing_y?], detrend: detrend?, block })
    }
}

/// Refuses heights that stand for no data, with their number and first places.
fn is_all_data(c: Cursor<'_>, cells: [usize; 2], heights: &[f64], units: Units) -> bool {
    let to_core = |mark| Domain::Position.to_core(units, mark);
    let Some(found) = no_data::far_off(heights, cells[1], to_core) else { return true };
    let wire = |height| Domain::Position.to_wire(units, height);
    let unit = Domain::Position.symbol(units);
    let places: Vec<_> = found.places.iter().map(|[i, j]| format!("[{i}, {j}]")).collect();
    let more = if found.count > places.len() { ", …" } else { "" };
    c.fault(
        FaultCode::Inconsistent,
        format_args!(
            "{} of {} heights stand for no data: {} {unit} at {}{more}, where the others span {} \
             {unit}. Fill them from their neighbours, or cut them off; a pit that is meant may be \
             as deep as 1000 times that span",
            found.count,
            found.of,
            wire(found.height),
            places.join(", "),
            rounded(wire(found.range)),
        ),
    );
    false
}

/// Returns a figure to three digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

impl Serialize for InUnits<'_, Surface> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (surface, units) = (self.0, self.1);
        let length = |value: &f64| Domain::Position.to_wire(units, *value);
        let rows: Vec<Vec<f64>> = surface
            .heights
            .chunks(surface.cells[1])
            .map(|row| row.iter().map(length).collect())
            .collect();
        let mut map = serializer.serialize_struct("Surface", 4)?;
        map.serialize_field("heights", &rows)?;
        map.serialize_field("spacing_x", &length(&surface.spacing[0]))?;
        map.serialize_field("spacing_y", &length(&surface.spacing[1]))?;
        map.serialize_field("detrend", surface.detrend.name())?;
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use crate::job::{Job, JobError};
    use base64::Engine as _;
    use base64::engine::general_purpose::STANDARD;
    use serde_json::{Value, json};

    fn job(surface: &Value) -> Value {
        let steel = json!({"young_modulus": 210_000, "poisson_ratio": 0.3});
        json!({
            "analysis": "three_dimensional",
            "upper": {"shape": {"type": "flat"}, "material": {"rigid": true}, "surface": surface},
            "lower": {"shape": {"type": "flat"}, "material": steel},
            "load": {"force": 100},
        })
    }

    /// Heights with a slope of 3 along x and -1 along y, and one peak.
    fn sloping() -> Vec<Vec<f64>> {
        let mut rows: Vec<Vec<f64>> =
            (0..8).map(|i| (0..10).map(|j| 3.0 * f64::from(i) - f64::from(j)).collect()).collect();
        rows[4][4] += 1.0;
        rows
    }

    fn pointers(job: &Value) -> Vec<String> {
        let Err(JobError::Fields(faults)) = Job::from_value(job) else { return Vec::new() };
        faults.into_iter().map(|fault| fault.pointer).collect()
    }

    #[test]
    fn heights_are_read_and_levelled() {
        let wire =
            json!({"heights": sloping(), "spacing_x": 0.1, "spacing_y": 0.2, "detrend": "plane"});
        let read = Job::from_value(&job(&wire)).unwrap();
        assert!(read.validate().is_ok());
        let surface = read.upper.surface.as_ref().unwrap();
        assert_eq!((surface.cells(), surface.spacing()), ([8, 10], [0.1, 0.2]));
        let levelled = surface.levelled();
        assert!(levelled.iter().all(|height| height.abs() < 0.2 || *height > 0.9), "{levelled:?}");
        assert!(levelled.iter().sum::<f64>().abs() < 1e-12);
    }

    /// An array in numpy's file format.
    fn npy(header: &str, data: &[u8]) -> Value {
        let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
        let header = format!("{header:<117}\n");
        bytes.extend(u16::try_from(header.len()).unwrap().to_le_bytes());
        bytes.extend(header.as_bytes());
        bytes.extend(data);
        json!({"npy_base64": STANDARD.encode(bytes)})
    }

    fn header(kind: &str, order: &str, shape: &str) -> String {
        format!("{{'descr': '{kind}', 'fortran_order': {order}, 'shape': {shape}, }}")
    }

    fn bytes(rows: &[Vec<f64>]) -> Vec<u8> {
        rows.iter().flatten().flat_map(|height| height.to_le_bytes()).collect()
    }

    #[test]
    fn heights_of_numpy_are_those_of_lists() {
        let of = |heights: Value, units: &str| {
            let mut one = job(&json!({"heights": heights, "spacing_x": 0.1, "spacing_y": 0.2}));
            one["units"] = json!(units);
            one["lower"]["material"]["young_modulus"] = json!(1e8);
            Job::from_value(&one).unwrap()
        };
        let rows = sloping();
        let turned: Vec<Vec<f64>> =
            (0..10).map(|j| (0..8).map(|i| rows[i][j]).collect()).collect();
        #[expect(clippy::cast_possible_truncation, reason = "small whole numbers")]
        let single: Vec<u8> =
            rows.iter().flatten().flat_map(|height| (*height as f32).to_le_bytes()).collect();
        for units in ["mm_N_MPa", "SI"] {
            let expected = of(json!(rows), units);
            for array in [
                npy(&header("<f8", "False", "(8, 10)"), &bytes(&rows)),
                npy(&header("<f8", "True", "(8, 10)"), &bytes(&turned)),
                npy(&header("<f4", "False", "(8, 10)"), &single),
                npy("{\"shape\":(8,10),\"fortran_order\":False,\"descr\":\"<f8\"}", &bytes(&rows)),
            ] {
                assert_eq!(of(array, units), expected);
            }
        }
    }

    #[test]
    fn every_fault_of_an_array_is_named() {
        let rows = sloping();
        let mut hole = rows.clone();
        hole[2][3] = f64::NAN;
        let good = bytes(&rows);
        for (heights, said) in [
            (npy(&header("<f8", "False", "(8, 10)"), &bytes(&hole)), "got NaN at [2, 3]"),
            (npy(&header(">f8", "False", "(8, 10)"), &good), "not \">f8\""),
            (npy(&header("|O", "False", "(8, 10)"), &good), "not \"|O\""),
            (npy(&header("<f8", "False", "(80,)"), &good), "two dimensions, not 1"),
            (npy(&header("<f8", "False", "(4, 20)"), &good), "got 4 × 20"),
            (npy(&header("<f8", "False", "(8, 11)"), &good), "704 bytes of data, not 640"),
            (npy(&header("<f8", "False", "(99999999999, 99999999999)"), &good), "at most 1048576"),
            (
                npy(&header("<f8", "False", &format!("({}1,)", "1, ".repeat(20_000))), &good),
                "not 20001",
            ),
            (npy(&header(&"<f8".repeat(20_000), "False", "(8, 10)"), &good), "<f8<f8"),
            (npy(&"{".repeat(60_000), &good), "not \"{{{{"),
            (npy("{}", &good), "a header as numpy.save writes it"),
            (npy(&header("<f8", "0", "(8, 10)"), &good), "a header as numpy.save writes it"),
            (npy(&header("<f8", "False", "(+8, 10)"), &good), "a header as numpy.save writes it"),
            (
                npy(
                    "{'descr': '<f8', 'fortran_order': False, 'shape': (8, 10), 'shape': (8, 10)}",
                    &good,
                ),
                "a header as numpy.save writes it",
            ),
            (
                json!({"npy_base64": STANDARD.encode(b"\x93NUMPY\x04\x00\xff\xff")}),
                "version 1 to 3",
            ),
            (json!({"npy_base64": "k05V"}), "as numpy.save writes it"),
            (json!({"npy_base64": STANDARD.encode(b"\x93NUMPY\x02\x00\xff\xff")}), "ends before"),
            (json!({"npy_base64": "no!"}), "must be Base64"),
            (json!({"npy_base64": 3}), "must be a string"),
        ] {
            let wire = json!({"heights": heights, "spacing_x": 0.1, "spacing_y": 0.2});
            let Err(JobError::Fields(faults)) = Job::from_value(&job(&wire)) else {
                panic!("{said}")
            };
            assert_eq!(faults[0].pointer, "/upper/surface/heights/npy_base64");
            assert!(faults.len() == 1 && faults[0].detail.contains(said), "{faults:?}");
            assert!(faults[0].detail.len() < 150, "{faults:?}");
        }
        let wire = json!({"heights": {"npy": ""}, "spacing_x": 0.1, "spacing_y": 0.2});
        let expected = ["/upper/surface/heights/npy", "/upper/surface/heights/npy_base64"];
        assert_eq!(pointers(&job(&wire)), expected);
    }

    #[test]
    fn every_fault_of_heights_is_named() {
        let mut rows = sloping();
        rows[3].pop();
        let wire = json!({"heights": rows, "spacing_x": 0, "detrend": "line"});
        let expected = [
            "/upper/surface/detrend",
            "/upper/surface/heights",
            "/upper/surface/spacing_x",
            "/upper/surface/spacing_y",
        ];
        let mut found = pointers(&job(&wire));
        found.sort();
        assert_eq!(found, expected);
        let good = json!({"heights": sloping(), "spacing_x": 0.1, "spacing_y": 0.2});
        let mut wrong = job(&good);
        wrong["load"] = json!({"onset": true});
        wrong["lower"]["surface"] =
            json!({"heights": sloping(), "spacing_x": 0.1, "spacing_y": 0.3});
        assert_eq!(pointers(&wrong), ["/load/onset", "/lower/surface", "/upper/surface"]);
        let mut roller = job(&good);
        roller["lower"]["shape"] = json!({"type": "roller", "radius": 5, "length": 8});
        assert_eq!(pointers(&roller), ["/upper/surface"]);
        let mut plane = job(&good);
        plane["analysis"] = json!("plane_strain");
        assert!(pointers(&plane).contains(&"/upper/surface".to_owned()));
    }
}
