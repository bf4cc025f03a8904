//! Undeformed outlines.
//!
//! Every shape is described in its own frame: the contact starts at the origin, `x` is tangential, and
//! heights are counted along the outward normal. Both bodies use the same convention, so swapping `upper` and
//! `lower` mirrors the problem.

use serde::ser::{Serialize, SerializeMap, Serializer};

use super::reader::{Cursor, Object};
use super::wire::InUnits;
use super::{Groove, PositiveF64, Profile, Quantity, Units};

/// The undeformed outline of a body.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// The half of a circular cylinder (a sphere in axisymmetry) that faces the other body, cut at its
    /// diametral plane, where it is supported.
    Cylinder {
        /// Radius R \[mm\].
        radius: PositiveF64,
    },
    /// A rectangle with its upper face in contact and its base supported.
    Block {
        /// Full width \[mm\], centred on the contact.
        width: PositiveF64,
        /// Height of the rectangle below the contact \[mm\].
        depth: PositiveF64,
    },
    /// A block with a concave circular trough across its upper face.
    Groove(Groove),
    /// A block whose upper face follows measured or designed points.
    Profile(Profile),
}

impl Shape {
    /// The words of the wire format's `type`.
    pub const TYPES: &'static [&'static str] = &["cylinder", "block", "groove", "profile"];

    /// The word of this shape in the wire format.
    pub const fn type_name(&self) -> &'static str {
        match self {
            Self::Cylinder { .. } => "cylinder",
            Self::Block { .. } => "block",
            Self::Groove(_) => "groove",
            Self::Profile(_) => "profile",
        }
    }

    pub(super) fn read(cursor: Cursor<'_>, units: Option<Units>) -> Option<Self> {
        let object = cursor.object()?;
        match object.required("type", |c| c.word(Self::TYPES))? {
            "cylinder" => {
                object.only(&["type", "radius"]);
                Some(Self::Cylinder { radius: length(&object, "radius", units)? })
            }
            "block" => {
                object.only(&["type", "width", "depth"]);
                let width = length(&object, "width", units);
                let depth = length(&object, "depth", units);
                Some(Self::Block { width: width?, depth: depth? })
            }
            "groove" => Groove::read(&object, units).map(Self::Groove),
            _ => Profile::read(&object, units).map(Self::Profile),
        }
    }
}

/// A required dimension.
pub(super) fn length(object: &Object<'_>, key: &str, units: Option<Units>) -> Option<PositiveF64> {
    object.required(key, |c| c.quantity(Quantity::Length, units))
}

impl Serialize for InUnits<'_, Shape> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("type", self.0.type_name())?;
        match self.0 {
            Shape::Cylinder { radius } => self.entry(&mut map, "radius", Quantity::Length, *radius)?,
            Shape::Block { width, depth } => {
                self.entry(&mut map, "width", Quantity::Length, *width)?;
                self.entry(&mut map, "depth", Quantity::Length, *depth)?;
            }
            Shape::Groove(groove) => {
                self.entry(&mut map, "radius", Quantity::Length, groove.radius())?;
                self.entry(&mut map, "width", Quantity::Length, groove.width())?;
                self.entry(&mut map, "depth", Quantity::Length, groove.depth())?;
            }
            Shape::Profile(profile) => {
                let in_units = |value| Quantity::Position.to_wire(self.1, value);
                let points: Vec<_> = profile.points().iter().map(|point| point.map(in_units)).collect();
                map.serialize_entry("points", &points)?;
                self.entry(&mut map, "depth", Quantity::Length, profile.depth())?;
            }
        }
        map.end()
    }
}
