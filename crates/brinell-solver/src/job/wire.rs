//! Writing of a job in its own units.

use serde::ser::{Serialize, SerializeMap, Serializer};

use super::fields::{Record, write_record};
use super::{
    BackstressTerm, HardenedCase, HardnessProfile, HardnessTest, InitialStress, MeshSettings,
    OutputSettings, Rolling, SolverSettings, Units,
};

/// A part of a job, to be written in these units.
pub(super) struct InUnits<'a, T>(pub &'a T, pub Units);

impl<T> InUnits<'_, T> {
    fn write<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error>
    where
        T: Record,
    {
        let mut map = serializer.serialize_map(None)?;
        write_record(self.0, &mut map, self.1)?;
        map.end()
    }
}

macro_rules! written_as_records {
    ($($settings:ty),+) => {$(
        impl Serialize for InUnits<'_, $settings> {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                self.write(serializer)
            }
        }
    )+};
}

written_as_records!(
    MeshSettings,
    SolverSettings,
    OutputSettings,
    BackstressTerm,
    HardenedCase,
    HardnessProfile,
    InitialStress,
    Rolling,
    HardnessTest
);
