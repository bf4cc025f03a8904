//! One of the two bodies.

use std::sync::Arc;

use serde::Serialize;
use strum::{IntoStaticStr, VariantArray};

use super::fields::InUnits;
use super::reader::Cursor;
use super::{Analysis, Deformable, Material, Named, Shape, Surface, Units, name};

/// One body of the contact: its shape, its material and the support of its far boundary.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// Undeformed outline.
    pub shape: Shape,
    /// Elastic constants and hardening curve, or rigid.
    pub material: Material,
    /// What people call the material.
    pub material_name: Option<String>,
    /// Support of the far boundary. A rigid body ignores it.
    pub support: FarSupport,
    /// Heights on top of the shape of a half-space.
    pub surface: Option<Arc<Surface>>,
}

impl Body {
    /// Returns Young's modulus \[MPa\]; `None` for a rigid body.
    pub fn young_modulus(&self) -> Option<f64> {
        self.deformable().map(|material| material.elastic.young_modulus.get())
    }

    /// Returns `(1 - ν²)/E` \[1/MPa\]; 0 of a rigid body.
    pub fn compliance(&self) -> f64 {
        self.deformable().map_or(0.0, |material| material.elastic.plane_strain_modulus().recip())
    }

    /// Returns the material; `None` of a rigid body.
    pub const fn deformable(&self) -> Option<&Deformable> {
        match &self.material {
            Material::Deformable(material) => Some(material),
            Material::Rigid => None,
        }
    }

    /// Whether the other body has the same figures; names are none.
    pub fn is_alike(&self, other: &Self) -> bool {
        let Self { shape, material, material_name: _, support, surface } = self;
        let figures = (&other.shape, &other.material, &other.support, &other.surface);
        (shape, material, support, surface) == figures
    }

    pub(super) fn read(cursor: Cursor<'_>, units: Option<Units>) -> Option<Self> {
        let object = cursor.object()?;
        object.only(&["shape", "support", "material", Surface::KEY]);
        let shape = object.required("shape", |c| Shape::read(c, units, &[]));
        let support = object.or("support", FarSupport::default(), |c| c.named());
        let material = object.required("material", |c| {
            let name = c.object()?.or("name", None, |c| name::read(c).map(Some));
            Some((Material::read(c, units)?, name?))
        });
        let surface =
            object.or(Surface::KEY, None, |c| Surface::read(c, units).map(Arc::new).map(Some));
        let (material, material_name) = material?;
        let (shape, support, surface) = (shape?, support?, surface?);
        Some(Self { shape, material, material_name, support, surface })
    }
}

impl InUnits<'_, Body> {
    /// Returns the body in the wire format. A half-space is written without the default support.
    pub fn of(&self, analysis: Analysis) -> impl Serialize {
        let has_support =
            analysis != Analysis::ThreeDimensional || self.0.support != FarSupport::default();
        WireBody {
            shape: InUnits(&self.0.shape, self.1),
            support: has_support.then_some(self.0.support),
            material: WireMaterial {
                name: self.0.material_name.as_deref(),
                figures: InUnits(&self.0.material, self.1),
            },
            surface: self.0.surface.as_deref().map(|surface| InUnits(surface, self.1)),
        }
    }
}

#[derive(Serialize)]
struct WireBody<'a> {
    shape: InUnits<'a, Shape>,
    #[serde(skip_serializing_if = "Option::is_none")]
    support: Option<FarSupport>,
    material: WireMaterial<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    surface: Option<InUnits<'a, Surface>>,
}

#[derive(Serialize)]
struct WireMaterial<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<&'a str>,
    #[serde(flatten)]
    figures: InUnits<'a, Material>,
}

/// The support of a body's far boundary: the diametral plane of a cylinder, the base of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, IntoStaticStr, VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum FarSupport {
    /// Both displacement components are held.
    #[default]
    Clamped,
    /// The normal component is held, the tangential one is free.
    Roller,
}

impl Named for FarSupport {}
