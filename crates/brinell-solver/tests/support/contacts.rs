//! Contacts of every law, shape and analysis, for the tests of what converges and the example that
//! prints all of it.

use std::f64::consts::PI;

use serde_json::{Value, json};

pub const ANALYSES: [&str; 3] = ["plane_strain", "plane_stress", "axisymmetric"];
const YIELD: f64 = 500.0;

/// Every law that yields at, or near, the same stress.
pub fn laws() -> [(&'static str, Value); 7] {
    [
        (
            "bilinear",
            json!({"law": "bilinear", "yield_stress": YIELD, "tangent_modulus": 10_500.0}),
        ),
        (
            "perfectly plastic",
            json!({"law": "bilinear", "yield_stress": YIELD, "tangent_modulus": 0.0}),
        ),
        (
            "ramberg_osgood",
            json!({"law": "ramberg_osgood", "reference_stress": YIELD, "offset": 0.3,
                "exponent": 5.0}),
        ),
        (
            "table",
            json!({"law": "table", "points": [[0.0, YIELD], [0.005, 600.0], [0.05, 700.0]]}),
        ),
        (
            "swift",
            json!({"law": "swift", "yield_stress": YIELD, "strain_offset": 0.005,
                "exponent": 0.2}),
        ),
        (
            "ludwik",
            json!({"law": "ludwik", "yield_stress": YIELD, "coefficient": 800.0, "exponent": 0.5}),
        ),
        (
            "voce",
            json!({"law": "voce", "yield_stress": YIELD, "saturation_stress": 800.0,
                "rate": 30.0}),
        ),
    ]
}

/// One surface of a pair.
pub struct Surface {
    pub name: &'static str,
    pub shape: Value,
    /// Negative where it is hollow \[1/mm\].
    pub curvature: f64,
}

/// Every shape.
pub fn surfaces() -> [Surface; 4] {
    let points: Vec<[f64; 2]> =
        (-800..=800).map(|k| f64::from(k) * 0.025).map(|x| [x, -x * x / 50.0]).collect();
    [
        Surface {
            name: "cylinder",
            shape: json!({"type": "cylinder", "radius": 20.0}),
            curvature: 1.0 / 20.0,
        },
        Surface {
            name: "block",
            shape: json!({"type": "block", "width": 60.0, "depth": 30.0}),
            curvature: 0.0,
        },
        Surface {
            name: "groove",
            shape: json!({"type": "groove", "radius": 50.0, "width": 60.0, "depth": 30.0}),
            curvature: -1.0 / 50.0,
        },
        Surface {
            name: "profile",
            shape: json!({"type": "profile", "points": points, "depth": 20.0}),
            curvature: 1.0 / 25.0,
        },
    ]
}

/// The pairs of surfaces that open away from where they touch.
pub fn pairs(surfaces: &[Surface]) -> impl Iterator<Item = [&Surface; 2]> {
    let pairs =
        surfaces.iter().flat_map(move |upper| surfaces.iter().map(move |lower| [upper, lower]));
    pairs.filter(|[upper, lower]| upper.curvature + lower.curvature > 0.0)
}

/// Two surfaces of one material, pressed together so hard that the elastic peak pressure would be
/// `ratio` yield stresses; ten elements over the half-width, tolerance 1e-6.
pub fn job(
    analysis: &str,
    coupling: &str,
    law: &Value,
    [upper, lower]: [&Surface; 2],
    ratio: f64,
) -> Value {
    let body = |surface: &Surface| {
        json!({"shape": surface.shape, "support": "clamped",
            "material": {"young_modulus": 210_000.0, "poisson_ratio": 0.3, "plasticity": law}})
    };
    let (peak, radius) = (ratio * YIELD, 1.0 / (upper.curvature + lower.curvature));
    let plane_strain = 210_000.0 / 1.82;
    let force = match analysis {
        "plane_strain" => PI * radius * peak.powi(2) / plane_strain,
        "plane_stress" => PI * radius * peak.powi(2) / 105_000.0,
        _ => (PI * peak).powi(3) * (radius / plane_strain).powi(2) / 6.0,
    };
    json!({"analysis": analysis, "upper": body(upper), "lower": body(lower),
        "load": {"force": force},
        "mesh": {"elements_per_half_width": 10}, "solver": {"coupling": coupling,
            "tolerance": 1e-6}})
}
