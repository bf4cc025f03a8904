//! A contact that rolls or slides over its track.

use strum::{IntoStaticStr, VariantArray};

use super::fields::{Field, read_record, record};
use super::reader::Cursor;
use super::{Domain, FaultCode, Named, PositiveF64, Units};

record! {
    /// A contact that passes over its track again and again, in the direction of x: a line in plane
    /// strain, an ellipse in three dimensions.
    #[derive(Copy)]
    pub struct Rolling("", "Rolling") {
        /// Force; on unit thickness in plane strain.
        pub force: PositiveF64 = Field::quantity(Domain::LineForce).label("Force", "P").example(2000.0),
        /// Passes at most.
        pub passes: u32 = Field::whole(1..=100).label("Passes", "N"),
        /// When to end: at the `verdict`, as soon as three passes running agree on it, or after
        /// all `passes`.
        pub until: Until = Field::choice::<Until>("Until").label("Until", ""),
        /// Traction over pressure in the whole contact, which slides. Positive where the traction
        /// on the lower body acts along the travel of the load (a slider, a braked wheel),
        /// negative for a driven wheel; the upper body has the opposite traction.
        pub friction: f64 = Field::pure(-1.0..=1.0).label("Friction", "μ"),
        /// Whether every second pass goes back. The friction keeps its sense to the travel.
        pub alternating: bool = Field::flag().label("There and back", ""),
        /// Length of the track over the elastic half-width or the semi-axis along the travel, after
        /// which the material comes back; 32 of a line and 12 in three dimensions, where it is
        /// missing.
        pub track: Option<f64> = Field::pure(8.0..=256.0).label("Length of the track", "Λ/a"),
        /// How a body without a backstress hardens under a load that turns round, of which its curve
        /// says nothing: by `both` rules, of which the worse decides, or by one alone.
        pub hardening: HardeningRule = Field::choice::<HardeningRule>("HardeningRule").label("Hardening", ""),
    }
}

impl Rolling {
    /// The key of this load.
    pub const KEY: &'static str = "rolling";

    /// Free rolling under a force until a verdict counts, in at most 30 passes.
    pub fn new(force: PositiveF64) -> Self {
        Self {
            force,
            passes: 30,
            until: Until::default(),
            friction: 0.0,
            alternating: false,
            track: None,
            hardening: HardeningRule::default(),
        }
    }

    /// Reads a load whose members but the force may be missing.
    ///
    /// The table has the force of a line; `force` is the quantity of a force in the analysis.
    pub(super) fn read(cursor: Cursor<'_>, units: Option<Units>, force: Domain) -> Option<Self> {
        let object = cursor.object()?;
        let is_given = object.has("force");
        if !is_given {
            object.fault("force", FaultCode::Required, format_args!("is required"));
        }
        let default = Self::new(PositiveF64::MICRO);
        let read: Option<Self> = read_record(&object, None, units, Some(default), &[]);
        let in_units = |load: Self| match units {
            Some(units) => load.with_force(units, [Domain::LineForce, force]),
            None => load,
        };
        read.filter(|_| is_given).map(in_units)
    }

    /// The load whose force is that of one quantity, with the number of another.
    pub(super) fn with_force(self, units: Units, [from, to]: [Domain; 2]) -> Self {
        let force = to.to_core(units, from.to_wire(units, self.force.get()));
        Self { force: PositiveF64::new(force).unwrap_or(self.force), ..self }
    }
}

/// When the passes of a load that rolls end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "snake_case")]
pub enum Until {
    /// As soon as three passes running agree on what becomes of the track.
    #[default]
    Verdict,
    /// After all of them.
    Passes,
}

impl Named for Until {}

/// How bodies without a backstress harden under a load that rolls.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, IntoStaticStr, VariantArray)]
#[strum(serialize_all = "snake_case")]
pub enum HardeningRule {
    /// Isotropically, and once more kinematically with the same uniaxial curve; the worse verdict
    /// decides.
    #[default]
    Both,
    /// Isotropically alone: every load shakes down in the end.
    Isotropic,
    /// Kinematically alone, with the same uniaxial curve.
    Kinematic,
}

impl Named for HardeningRule {}
