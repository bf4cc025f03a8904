//! Between what an approach is measured.

use crate::job::{
    Block, Body, Cone, Cylinder, Groove, Job, Material, Parabola, Power, Punch, Shape, Side,
    Sphere, Wedge,
};
use crate::units::UnitConverter;

/// Between what an approach is measured.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) enum Datum {
    /// Points of both half-spaces far from the contact, which have no supported end.
    #[default]
    FarPoints,
    /// None: half-planes approach without limit.
    None,
    /// A place of each body.
    Places([String; 2]),
}

impl Datum {
    /// Returns the datum of meshed bodies.
    pub fn of(job: &Job, write: UnitConverter) -> Self {
        let bodies = job.bodies();
        let in_hole = bodies.iter().any(|body| matches!(body.shape, Shape::Hole(_)));
        Self::Places(Side::BOTH.map(|side| place(side, bodies[side.member()], in_hole, write)))
    }

    /// Returns the datum for `between`.
    pub fn between(&self) -> String {
        self.joined(" and ")
    }

    fn joined(&self, word: &str) -> String {
        match self {
            Self::FarPoints => {
                "points of both half-spaces far from the contact; bodies of finite \
                                size give way by something else in their bulk and at their \
                                supports"
                    .to_owned()
            }
            Self::None => "none: how far half-planes approach under a line load depends on where \
                           that is counted from"
                .to_owned(),
            Self::Places(places) => places.join(word),
        }
    }
}

impl std::fmt::Display for Datum {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.joined(" towards "))
    }
}

fn place(side: Side, body: &Body, in_hole: bool, write: UnitConverter) -> String {
    let base = |depth: f64| {
        format!("the base of the {side} body, {} from the contact", write.exact_length(depth))
    };
    match (&body.material, &body.shape) {
        (Material::Rigid, _) => format!("the rigid {side} body"),
        (_, Shape::Cylinder(_) | Shape::Sphere(_)) if in_hole => {
            format!("the mean displacement of the {side} body")
        }
        (_, Shape::Cylinder(Cylinder { radius }) | Shape::Sphere(Sphere { radius, .. })) => {
            format!(
                "the diametral plane of the {side} body, {} from the contact",
                write.exact_length(radius.get())
            )
        }
        (_, Shape::Hole(hole)) => format!(
            "the outer edge of the {side} body, {} from the hole",
            write.length_text(hole.wall())
        ),
        (_, Shape::Profile(profile)) => base(profile.depth.get() + profile.top()),
        (_, Shape::Ellipse(ellipse)) => base(ellipse.semi_axis_y.get()),
        (
            _,
            Shape::Block(Block { depth, .. })
            | Shape::Groove(Groove { depth, .. })
            | Shape::Wedge(Wedge { depth, .. })
            | Shape::Cone(Cone { depth, .. })
            | Shape::Punch(Punch { depth, .. })
            | Shape::Parabola(Parabola { depth, .. })
            | Shape::Power(Power { depth, .. }),
        ) => base(depth.get()),
        (_, Shape::Curved(_) | Shape::Roller(_) | Shape::Flat(_)) => {
            format!("the far {side} body")
        }
    }
}
