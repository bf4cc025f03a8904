//! Initial stress of a body: from grinding, peening or hardening.

use super::fields::{Field, FieldTable, Record as _, read_record, record};
use super::over_depth::{OverDepth, faults_of_depths};
use super::reader::Cursor;
use super::reader::text::five_digits;
use super::{Analysis, Domain, FaultCode, FieldError, NonNegativeF64, Units};
use crate::material::{HardeningLaw, InitialStressProfile, StrengthProfile};

record! {
    /// Stress along the surface at one depth, before any load; straight between depths, constant
    /// beyond the ends.
    #[derive(Copy)]
    pub struct InitialStress("", "Initial stress") {
        /// Depth below the surface.
        pub depth: NonNegativeF64 = Field::quantity(Domain::Depth).label("Depth", "z").example(0.05),
        /// Stress along the surface in the plane of the section, in three dimensions along x;
        /// tension positive.
        pub sigma_x: f64 = Field::quantity(Domain::SignedStress).label("Along the surface", "σ_x").example(-600.0),
        /// Stress along the surface out of that plane, in three dimensions along y, in axisymmetry
        /// equal to `sigma_x`, in plane stress zero.
        pub sigma_z: f64 = Field::quantity(Domain::SignedStress).label("Out of plane", "σ_z").example(-600.0),
    }
}

impl InitialStress {
    /// The key of the initial stress in a material.
    pub const KEY: &'static str = "initial_stress";
    /// Returns the fields of a row, for the schema and the form.
    pub const fn table() -> FieldTable {
        Self::TABLE
    }

    pub(super) fn read_all(cursor: Cursor<'_>, units: Option<Units>) -> Option<Vec<Self>> {
        cursor.array(1..=OverDepth::MAX_POINTS, |item| {
            read_record(&item.object()?, None, units, None, &[])
        })
    }

    /// Returns rows in the order of depth as a profile.
    pub(super) fn profile(rows: &[Self]) -> InitialStressProfile {
        InitialStressProfile::new(
            rows.iter().map(|row| [row.depth.get(), row.sigma_x, row.sigma_z]),
        )
    }

    /// Returns the faults of rows with a hardening curve and its factors over depth.
    pub(super) fn faults(
        rows: &[Self],
        law: Option<&dyn HardeningLaw>,
        strength: Option<&StrengthProfile>,
    ) -> Vec<FieldError> {
        let mut faults =
            faults_of_depths(rows.iter().map(|row| row.depth.get()), |k| format!("/{k}/depth"));
        let Some(law) = law.filter(|_| faults.is_empty() && !rows.is_empty()) else {
            return faults;
        };
        if law.yield_stress() <= 0.0 {
            let detail = "needs a hardening curve with a yield point, below which the stress \
                          before the load lies; the law `ramberg_osgood` has none, `swift`, \
                          `ludwik` and `table` have";
            faults.push(FieldError {
                pointer: String::new(),
                code: FaultCode::Inconsistent,
                detail: detail.to_owned(),
            });
            return faults;
        }
        // Between the depths of both profiles, the stress is convex and its limit linear in the
        // depth, so that the largest ratio lies at one of these depths.
        let profile = Self::profile(rows);
        let knots = strength.map_or(&[][..], StrengthProfile::points);
        let depths =
            rows.iter().map(|row| row.depth.get()).chain(knots.iter().map(|[depth, _]| *depth));
        let excess = |depth: f64| {
            let [x, z] = profile.at(depth);
            let limit =
                law.yield_stress() * strength.map_or(1.0, |strength| strength.factor(depth));
            (depth, (x * x - x * z + z * z).sqrt(), limit)
        };
        let worst = depths.map(excess).max_by(|a, b| (a.1 / a.2).total_cmp(&(b.1 / b.2)));
        if let Some((depth, stress, limit)) = worst.filter(|(_, stress, limit)| stress > limit) {
            // Between two rows the limit changes where the strength has a depth of its own.
            let above = rows.iter().rposition(|row| row.depth.get() <= depth).unwrap_or(0);
            let detail = format!(
                "yields by itself: at or below row {} its von Mises stress is {} times the yield \
                 stress",
                above + 1,
                five_digits(stress / limit)
            );
            faults.push(FieldError {
                pointer: String::new(),
                code: FaultCode::Inconsistent,
                detail,
            });
        }
        faults
    }

    /// Returns the faults of rows in an analysis.
    pub(super) fn faults_in(rows: &[Self], analysis: Analysis) -> Vec<FieldError> {
        let (is_wrong, detail): (fn(&Self) -> bool, _) = match analysis {
            Analysis::PlaneStrain | Analysis::ThreeDimensional => return Vec::new(),
            Analysis::PlaneStress => (|row| row.sigma_z.abs() > 0.0, "must be 0 in plane stress"),
            Analysis::Axisymmetric => (
                |row| (row.sigma_x - row.sigma_z).abs() > 1e-9 * row.sigma_x.abs(),
                "must equal `sigma_x` in axisymmetry: no stress that depends on depth alone is in \
                 equilibrium otherwise",
            ),
        };
        let faulty = rows.iter().enumerate().filter(|(_, row)| is_wrong(row));
        faulty.map(|(k, _)| FieldError::new(format!("/{k}/sigma_z"), detail)).collect()
    }
}
