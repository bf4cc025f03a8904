//! The two unit systems of the wire format.

use serde::Serialize;

use super::Named;

/// The units of lengths, forces and stresses in a job and its result.
///
/// The core works in [`Units::MmNMpa`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub enum Units {
    /// Millimetre, newton, megapascal. Line forces are N/mm.
    #[default]
    #[serde(rename = "mm_N_MPa")]
    MmNMpa,
    /// Metre, newton, pascal. Line forces are N/m.
    #[serde(rename = "SI")]
    Si,
}

impl Units {
    /// Returns the number of millimetres in one unit of length.
    pub const fn length(self) -> f64 {
        match self {
            Self::MmNMpa => 1.0,
            Self::Si => 1.0e3,
        }
    }

    /// Returns the number of megapascals in one unit of stress.
    pub const fn stress(self) -> f64 {
        match self {
            Self::MmNMpa => 1.0,
            Self::Si => 1.0e-6,
        }
    }

    /// Returns the number of newtons per millimetre in one unit of line force (plane analyses).
    pub const fn line_force(self) -> f64 {
        match self {
            Self::MmNMpa => 1.0,
            Self::Si => 1.0e-3,
        }
    }

    /// Returns the name of the units in the wire format.
    pub const fn name(self) -> &'static str {
        match self {
            Self::MmNMpa => "mm_N_MPa",
            Self::Si => "SI",
        }
    }
}

impl Named for Units {
    const ALL: &'static [Self] = &[Self::MmNMpa, Self::Si];

    fn name(self) -> &'static str {
        Self::name(self)
    }
}
