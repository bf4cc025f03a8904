//! Random jobs over the whole format, seeded.

#![allow(dead_code, reason = "each program uses a part")]

use serde_json::{Map, Value, json};

/// The generator splitmix64.
pub struct Random(pub u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn decades(&mut self, low: f64, high: f64) -> f64 {
        10f64.powf(self.between(low.log10(), high.log10()))
    }

    pub fn happens(&mut self, probability: f64) -> bool {
        self.unit() < probability
    }

    pub fn count(&mut self, most: u64) -> u64 {
        1 + self.bits() % most
    }

    fn one_of<T: Clone>(&mut self, choices: &[T]) -> T {
        let count = choices.len() as u64;
        choices[usize::try_from(self.bits() % count).unwrap_or_default()].clone()
    }
}

/// What the parts of a job have in common, in millimetres and megapascals.
struct Scale {
    analysis: &'static str,
    is_flow: bool,
    radius: f64,
    young: f64,
    /// Half-width and peak pressure that an elastic contact of two cylinders has under the force.
    half_width: f64,
    peak: f64,
    yield_stress: f64,
}

/// Any job that a person might ask for, on a mesh of so many elements over the half-width: a
/// contact of half of a thousandth to a twentieth of the radius, at up to six yield stresses.
pub fn job(random: &mut Random, elements: &[u32]) -> Value {
    let mut job = in_millimetres(random, elements);
    if random.happens(0.2) {
        in_si(&mut job);
    }
    job
}

/// Writes a job in millimetres in metres, pascals and newtons.
pub fn in_si(job: &mut Value) {
    let analysis = job["analysis"].as_str().unwrap_or_default().to_owned();
    to_si(job, &analysis);
    job["units"] = json!("SI");
}

/// A job as above, in millimetres, newtons and megapascals.
pub fn in_millimetres(random: &mut Random, elements: &[u32]) -> Value {
    let analysis = random.one_of(&["plane_strain", "plane_stress", "axisymmetric"]);
    let [radius, young] = [random.decades(0.1, 1e3), random.decades(1e3, 3e5)];
    let half_width = radius * random.decades(5e-4, 0.05);
    let peak = 0.3 * young * half_width / radius;
    let yield_stress = peak / random.between(0.8, 6.0);
    let is_flow = random.happens(0.35);
    let scale = Scale { analysis, is_flow, radius, young, half_width, peak, yield_stress };
    let first = body(random, &scale, true);
    let second = body(random, &scale, false);
    let (upper, lower) = if random.happens(0.5) { (first, second) } else { (second, first) };
    let mut job = json!({"analysis": analysis, "upper": upper, "lower": lower,
        "load": load(random, &scale),
        "mesh": {"elements_per_half_width": random.one_of(elements)}});
    let mut solver = Map::new();
    solver.insert("theory".into(), json!(if is_flow { "flow" } else { "deformation" }));
    if is_flow && random.happens(0.3) {
        solver.insert("increments".into(), json!(random.count(5)));
    }
    if random.happens(0.15) {
        let coupling = random.one_of(&["strong", "weak", "secant_stiffness"]);
        // Secant moduli are those of deformation theory.
        if !is_flow || coupling != "secant_stiffness" {
            solver.insert("coupling".into(), json!(coupling));
        }
    }
    if random.happens(0.1) {
        solver.insert("contact".into(), json!("simplex"));
    }
    job["solver"] = Value::Object(solver);
    if random.happens(0.1) {
        job["output"] = json!({"fields": true});
    }
    job
}

/// A smooth contact of steels at 0.8 to 5.5 yield stresses: a cylinder or ball on a block or on its
/// equal, by either theory.
pub fn ordinary(random: &mut Random, elements: u32) -> Value {
    let analyses =
        ["plane_strain", "plane_strain", "axisymmetric", "axisymmetric", "plane_stress"];
    let analysis = random.one_of(&analyses);
    let (radius, yield_stress) = (random.between(5.0, 50.0), random.between(300.0, 1500.0));
    let peak = yield_stress * random.between(0.8, 5.5);
    let tangent_modulus = 210_000.0 * random.one_of(&[0.0, 0.01, 0.05]);
    let elastic = json!({"young_modulus": 210_000, "poisson_ratio": 0.3});
    let mut yielding = elastic.clone();
    yielding["plasticity"] = json!({"law": "bilinear", "yield_stress": yield_stress,
        "tangent_modulus": tangent_modulus});
    let is_pair = random.happens(0.4);
    let effective = if is_pair { 0.5 * radius } else { radius };
    let modulus = 210_000.0 / (2.0 * 0.91);
    let force = if analysis == "axisymmetric" {
        (std::f64::consts::PI * peak).powi(3) * effective.powi(2) / (6.0 * modulus * modulus)
    } else {
        std::f64::consts::PI * peak * peak * effective / modulus
    };
    let cylinder = json!({"type": "cylinder", "radius": radius});
    let lower = if is_pair {
        cylinder.clone()
    } else {
        json!({"type": "block", "width": 4.0 * radius, "depth": 3.0 * radius})
    };
    let upper = if random.happens(0.5) { yielding.clone() } else { elastic };
    let (is_flow, is_unloaded) = (random.happens(0.5), random.happens(0.4));
    let load = if is_flow && is_unloaded {
        json!({"history": [{"force": force}, {"force": 0}]})
    } else {
        json!({"force": force})
    };
    json!({"analysis": analysis, "upper": {"shape": cylinder, "material": upper},
        "lower": {"shape": lower, "material": yielding}, "load": load,
        "mesh": {"elements_per_half_width": elements},
        "solver": {"theory": if is_flow { "flow" } else { "deformation" }}})
}

/// Which loads that roll are drawn.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Rolls {
    /// Discs on discs, at 2.2 to 6 times the yield stress in shear and frictions up to 0.35.
    Lines,
    /// Discs whose traction is 0.7 to 1 of what the material bears at the surface, at 3 to 8 times
    /// the yield stress in shear.
    NearTraction,
    /// Balls on flats and in grooves, at 2 to 6 times the yield stress.
    Balls,
}

/// Three passes of a load on the default columns.
pub fn rolling(random: &mut Random, rolls: Rolls) -> Value {
    let yield_stress = random.between(300.0, 900.0);
    let mut law = json!({"law": "bilinear", "yield_stress": yield_stress, "tangent_modulus": 0});
    // What the surface bears in the end over the yield stress.
    let strength = match random.one_of(&[0, 1, 2, 3]) {
        0 => 1.0,
        1 => {
            law["tangent_modulus"] = json!(random.decades(500.0, 20_000.0));
            if rolls == Rolls::NearTraction { 1.0 } else { f64::INFINITY }
        }
        2 => {
            law["law"] = json!("voce");
            law["saturation_stress"] = json!(1.5 * yield_stress);
            law["rate"] = json!(random.decades(10.0, 200.0));
            law.as_object_mut().map(|law| law.remove("tangent_modulus"));
            1.5
        }
        _ => {
            let (modulus, rate) = (random.decades(1e4, 1e5), random.decades(100.0, 500.0));
            law["backstress"] = json!([{"modulus": modulus, "rate": rate}]);
            1.0 + modulus / rate / yield_stress
        }
    };
    let k = yield_stress / 3f64.sqrt();
    let peak = match rolls {
        Rolls::Lines => k * random.between(2.2, 6.0),
        Rolls::NearTraction => k * random.between(3.0, 8.0),
        Rolls::Balls => yield_stress * random.between(2.0, 6.0),
    };
    let sense = random.one_of(&[1.0, -1.0]);
    let most = 0.99 * k * strength / peak;
    let friction = match rolls {
        Rolls::NearTraction => sense * random.between(0.7, 1.0) * k * strength / peak,
        _ if random.happens(0.4) => 0.0,
        _ => sense * random.between(0.02, 0.35_f64.min(most)),
    };
    let elastic = json!({"young_modulus": 210_000, "poisson_ratio": 0.3});
    let mut yielding = elastic.clone();
    yielding["plasticity"] = law;
    let rolling = |force: f64| {
        json!({"rolling": {"force": force, "friction": friction, "passes": 3, "until": "passes",
            "hardening": "isotropic"}})
    };
    let modulus = 210_000.0 / (2.0 * 0.91);
    let radius = random.decades(2.0, 50.0);
    if rolls == Rolls::Balls {
        let force = std::f64::consts::PI.powi(3) * peak.powi(3) * radius.powi(2)
            / (6.0 * modulus * modulus);
        return json!({"analysis": "three_dimensional",
            "upper": {"shape": {"type": "sphere", "radius": radius}, "material": elastic},
            "lower": {"shape": {"type": "flat"}, "material": yielding},
            "load": rolling(force), "solver": {"theory": "flow"}});
    }
    let force = std::f64::consts::PI * peak * peak * 0.5 * radius / modulus;
    json!({"analysis": "plane_strain",
        "upper": {"shape": {"type": "cylinder", "radius": radius}, "material": elastic},
        "lower": {"shape": {"type": "cylinder", "radius": radius}, "material": yielding},
        "load": rolling(force), "solver": {"theory": "flow"}})
}

/// Half-spaces that a person might press together: a contact of half of a thousandth to a
/// twentieth of the radius, at up to five yield stresses.
pub fn half_spaces(random: &mut Random) -> Value {
    let [radius, young] = [random.decades(0.5, 100.0), random.decades(1e4, 3e5)];
    let half_width = radius * random.decades(1e-3, 0.04);
    // Of two balls, roughly.
    let peak = half_width * young / (std::f64::consts::PI * radius);
    let force = 2.0 / 3.0 * std::f64::consts::PI * half_width * half_width * peak;
    let rotation = random.between(-90.0, 90.0);
    let curved = |x: f64, y: f64| {
        json!({"type": "curved", "radius_x": x, "radius_y": y,
        "rotation": rotation})
    };
    let upper = match random.one_of(&[0, 1, 2]) {
        0 => json!({"type": "sphere", "radius": radius}),
        1 => curved(radius, radius * random.decades(1.0, 20.0)),
        _ => curved(radius, 3.0 * radius),
    };
    let lower = match random.one_of(&[0, 1, 2]) {
        0 => json!({"type": "flat"}),
        1 => json!({"type": "sphere", "radius": radius * random.decades(0.5, 5.0)}),
        // Wider than the largest radius of the upper body.
        _ => curved(-25.0 * radius, 30.0 * radius),
    };
    let mut material = |rigid: f64| {
        if random.happens(rigid) {
            return json!({"rigid": true});
        }
        let mut steel = json!({"young_modulus": young, "poisson_ratio": random.between(0.2, 0.4)});
        if random.happens(0.6) {
            steel["plasticity"] = json!({"law": "bilinear",
                "yield_stress": peak / random.between(1.2, 5.0),
                "tangent_modulus": random.between(0.0, 0.1) * young});
        }
        steel
    };
    let (upper_material, lower_material) = (material(0.3), material(0.0));
    let is_flow = random.happens(0.3);
    let load = match random.one_of(&[0, 1, 2]) {
        0 if is_flow => {
            json!({"history": [{"force": force}, {"force": 0}, {"force": 0.8 * force}]})
        }
        0 => json!({"forces": [0.3 * force, force]}),
        1 => json!({"approach": half_width * half_width / radius}),
        _ => json!({"force": force}),
    };
    let cells = 4 + random.one_of(&[0, 1, 2]);
    json!({
        "analysis": "three_dimensional",
        "upper": {"shape": upper, "material": upper_material},
        "lower": {"shape": lower, "material": lower_material},
        "load": load,
        "mesh": {"elements_per_half_width": cells},
        "solver": {"theory": if is_flow { "flow" } else { "deformation" }},
    })
}

/// Radius of the upper body of a contact in three dimensions, along x.
fn upper_radius(job: &Value) -> f64 {
    let shape = &job["upper"]["shape"];
    shape["radius"].as_f64().or_else(|| shape["radius_x"].as_f64()).unwrap_or(1.0)
}

/// Replaces the upper body of a contact in three dimensions by a roller of its radius, on a flat.
pub fn put_roller(random: &mut Random, job: &mut Value) {
    let radius = upper_radius(job);
    let length = radius * random.between(0.3, 1.5);
    let mut roller = json!({"type": "roller", "radius": radius, "length": length});
    match random.one_of(&[0, 1, 2, 3]) {
        0 => roller["profile"] = json!("iso_16281"),
        1 => {
            roller["profile"] = json!("crowned");
            roller["crown_radius"] = json!(100.0 * radius);
        }
        _ => {}
    }
    if random.happens(0.3) {
        roller["tilt"] = json!(random.between(-0.5, 0.5));
    }
    job["upper"]["shape"] = roller;
    job["lower"]["shape"] = json!({"type": "flat"});
}

/// Any contact in three dimensions: half-spaces as above, rollers, rough surfaces, strength over
/// depth, onsets and targets, in both systems of units.
pub fn in_three_dimensions(random: &mut Random) -> Value {
    let mut job = half_spaces(random);
    let radius = upper_radius(&job);
    let force = &job["load"]["force"];
    let force = force.as_f64().or_else(|| job["load"]["forces"][1].as_f64());
    let force = force.or_else(|| job["load"]["history"][0]["force"].as_f64());
    match random.one_of(&[0, 0, 0, 1, 2]) {
        1 => put_roller(random, &mut job),
        2 => {
            let spacing = 0.002 * radius;
            let rows: Vec<Vec<f64>> = (0..10)
                .map(|_| (0..10).map(|_| random.between(-1.0, 1.0) * 1e-3 * spacing).collect())
                .collect();
            job["lower"]["shape"] = json!({"type": "flat"});
            job["lower"]["surface"] =
                json!({"spacing_x": spacing, "spacing_y": spacing, "heights": rows});
        }
        _ => {}
    }
    if let (Some(force), true) = (force, random.happens(0.15)) {
        let yields =
            ["upper", "lower"].iter().any(|side| job[*side]["material"]["plasticity"].is_object());
        // The force that makes a wide contact in a raceway of nearly the radius is sought for long.
        let is_raceway = job["lower"]["shape"]["radius_x"].as_f64().is_some_and(|x| x < 0.0);
        job["load"] = match random.one_of(&[0, 1, 2]) {
            0 if yields => json!({"onset": true}),
            1 if !is_raceway => json!({"target": {"half_width": 0.01 * radius}}),
            _ => json!({"force": 2.0 * force}),
        };
    }
    for side in ["upper", "lower"] {
        let plasticity = &mut job[side]["material"]["plasticity"];
        if plasticity.is_object() && random.happens(0.2) {
            *plasticity = json!({"law": "bilinear", "yield_stress": plasticity["yield_stress"],
                "tangent_modulus": plasticity["tangent_modulus"],
                "over_depth": [[0, 1.4], [0.01 * radius, 1.0]]});
        } else if plasticity.is_null()
            && let Some(material) = job[side]["material"].as_object_mut()
        {
            material.remove("plasticity");
        }
    }
    if random.happens(0.3) {
        in_si(&mut job);
    }
    job
}

/// A hardness test of a block, by any scale, on a mesh of few elements.
pub fn hardness(random: &mut Random) -> Value {
    let yield_stress = random.decades(100.0, 2000.0);
    let test = match random.one_of(&[0, 1, 2, 3, 4, 5]) {
        0 => json!("HBW 10/3000"),
        1 => json!("HBW 2.5/62.5"),
        2 => json!({"scale": "HV", "force_kgf": random.one_of(&[1, 10, 30])}),
        3 => json!("HRC"),
        4 => json!("HRB"),
        _ => json!({"scale": "sphere", "ball": random.decades(0.01, 10.0),
            "force": yield_stress * 1e-3}),
    };
    let coefficient = yield_stress * random.decades(0.1, 3.0);
    let law = match random.one_of(&[0, 1, 2]) {
        0 => json!({"law": "bilinear", "yield_stress": yield_stress,
            "tangent_modulus": 2e5 * random.decades(1e-3, 0.1)}),
        1 => json!({"law": "ludwik", "yield_stress": yield_stress,
            "coefficient": coefficient, "exponent": random.between(0.1, 0.6)}),
        _ => json!({"law": "swift", "yield_stress": yield_stress,
            "strain_offset": random.decades(1e-3, 0.03), "exponent": random.between(0.05, 0.4)}),
    };
    json!({
        "analysis": "axisymmetric",
        "lower": {"shape": {"type": "block", "width": 200, "depth": 100},
            "material": {"young_modulus": 2e5, "poisson_ratio": 0.3, "plasticity": law}},
        "load": {"hardness": test},
        "mesh": {"elements_per_half_width": random.one_of(&[6, 8])},
        "solver": {"theory": "flow", "increments": 8},
    })
}

fn load(random: &mut Random, scale: &Scale) -> Value {
    let Scale { half_width, radius, peak, .. } = *scale;
    let force = if scale.analysis == "axisymmetric" {
        2.0 * peak * half_width.powi(2)
    } else {
        1.5 * peak * half_width
    };
    let approach = half_width * half_width / radius;
    if scale.is_flow {
        let mut steps = vec![json!({"force": force})];
        for _ in 0..random.count(3) {
            steps.push(match random.one_of(&[0, 0, 1, 2, 3]) {
                0 => json!({"force": 0}),
                1 => json!({"force": force * random.between(0.1, 1.2)}),
                2 => json!({"force": force}),
                _ => json!({"approach": approach * random.between(0.1, 2.0)}),
            });
        }
        return json!({"history": steps});
    }
    match random.one_of(&[0, 0, 0, 1, 2, 3, 4]) {
        0 => json!({"force": force}),
        1 => json!({"approach": approach * random.between(0.3, 2.0)}),
        2 => json!({"forces": [0.3 * force, 0.7 * force, force, 0.5 * force]}),
        3 => json!({"approaches": [0.5 * approach, approach, 0.8 * approach]}),
        _ => json!({"onset": true}),
    }
}

/// The first of the two is convex; only it may be rigid, of the two of a job at least one has to
/// deform.
fn body(random: &mut Random, scale: &Scale, is_first: bool) -> Value {
    let (shape, must_be_rigid) =
        if is_first { convex(random, scale) } else { (counterpart(random, scale), false) };
    if must_be_rigid || is_first && random.happens(0.1) {
        return json!({"shape": shape, "material": {"rigid": true}});
    }
    let mut material = json!({"young_modulus": scale.young * random.one_of(&[1.0, 1.0, 0.2, 5.0]),
        "poisson_ratio": random.one_of(&[0.0, 0.2, 0.3, 0.3, 0.45, 0.499])});
    if random.happens(0.8) {
        let mut plasticity = plasticity(random, scale);
        if scale.is_flow && random.happens(0.4) {
            let terms: Vec<Value> = (0..random.count(4))
                .map(|_| {
                    let rate = if random.happens(0.3) { 0.0 } else { random.decades(1.0, 1000.0) };
                    json!({"modulus": scale.young * random.decades(1e-3, 0.3), "rate": rate})
                })
                .collect();
            plasticity["backstress"] = json!(terms);
        }
        if random.happens(0.1) {
            let depth = scale.half_width * random.between(0.3, 3.0);
            plasticity["over_depth"] = json!([[0, random.between(1.0, 2.0)], [depth, 1]]);
        }
        material["plasticity"] = plasticity;
    }
    json!({"shape": shape, "support": random.one_of(&["clamped", "roller"]), "material": material})
}

/// A shape that sticks out, and whether only a rigid body may have it.
fn convex(random: &mut Random, scale: &Scale) -> (Value, bool) {
    let Scale { radius, half_width, .. } = *scale;
    let [width, depth] = [radius * random.between(0.5, 2.0), radius * random.between(1.0, 4.0)];
    let shape = match random.one_of(&[0, 0, 0, 0, 1, 2, 3, 4, 5, 6]) {
        0 => json!({"type": "cylinder", "radius": radius}),
        1 => json!({"type": "parabola", "radius": radius, "width": width, "depth": depth}),
        2 => {
            json!({"type": "ellipse", "semi_axis_x": radius,
                "semi_axis_y": radius * random.between(0.4, 2.0)})
        }
        3 => {
            // As high at the half-width as a cylinder.
            let exponent = random.between(1.2, 6.0);
            let height = half_width * half_width / (2.0 * radius);
            let scale =
                (height / half_width.powf(exponent)).powf((1.0 - exponent).recip()).min(1e6);
            json!({"type": "power", "exponent": exponent, "scale": scale,
                "width": 8.0 * half_width, "depth": radius})
        }
        4 => {
            let kind = if scale.analysis == "axisymmetric" { "cone" } else { "wedge" };
            let angle = (0.3 * half_width / radius).atan().to_degrees().max(0.1);
            let mut shape = json!({"type": kind, "angle": angle, "width": width, "depth": depth});
            let tip_radius = half_width * random.one_of(&[0.0, 0.1, 1.0]);
            if tip_radius > 0.0 {
                shape["tip_radius"] = json!(tip_radius);
            }
            shape
        }
        5 => {
            let points: Vec<[f64; 2]> = (0..=16)
                .map(|k| (f64::from(k) / 8.0 - 1.0) * 6.0 * half_width)
                .map(|x| [x, -x * x / (2.0 * radius)])
                .filter(|[x, _]| scale.analysis != "axisymmetric" || *x >= 0.0)
                .collect();
            let interpolation = random.one_of(&["smooth", "smooth", "linear"]);
            json!({"type": "profile", "points": points, "depth": radius,
                "interpolation": interpolation})
        }
        _ => {
            let width = 2.0 * half_width;
            let mut shape = json!({"type": "punch", "width": width, "depth": radius});
            let edge_radius = width * random.one_of(&[0.0, 0.02, 0.2]);
            if edge_radius > 0.0 {
                shape["edge_radius"] = json!(edge_radius);
            }
            return (shape, true);
        }
    };
    (shape, false)
}

fn counterpart(random: &mut Random, scale: &Scale) -> Value {
    let radius = scale.radius;
    let [size, depth] = [random.between(1.5, 4.0) * radius, random.between(1.0, 4.0) * radius];
    match random.one_of(&[0, 0, 1, 1, 2]) {
        0 => json!({"type": "cylinder", "radius": size}),
        1 => json!({"type": "block", "width": 2.0 * size, "depth": depth}),
        _ => json!({"type": "groove", "radius": size, "width": radius, "depth": depth}),
    }
}

fn plasticity(random: &mut Random, scale: &Scale) -> Value {
    let (young, limit) = (scale.young, scale.yield_stress);
    let exponent = random.decades(0.02, 0.9);
    match random.one_of(&[0, 1, 2, 3, 4, 5, 6]) {
        0 => json!({"law": "bilinear", "yield_stress": limit, "tangent_modulus": 0}),
        1 => {
            json!({"law": "bilinear", "yield_stress": limit,
                "tangent_modulus": young * random.decades(1e-4, 0.15)})
        }
        2 => {
            json!({"law": "ludwik", "yield_stress": limit,
                "coefficient": limit * random.decades(0.1, 10.0),
            "exponent": exponent})
        }
        3 => {
            json!({"law": "swift", "yield_stress": limit,
                "strain_offset": random.decades(1e-4, 0.05),
            "exponent": exponent})
        }
        4 => {
            json!({"law": "voce", "yield_stress": limit,
                "saturation_stress": limit * random.between(1.05, 3.0),
            "rate": random.decades(1.0, 300.0)})
        }
        5 => json!({"law": "table", "points": [[0, limit],
            [random.between(0.01, 0.05), limit * random.between(1.0, 1.5)], [0.2, 1.5 * limit]]}),
        _ => {
            json!({"law": "ramberg_osgood", "reference_stress": limit,
                "offset": random.decades(0.1, 1.0),
            "exponent": random.between(3.0, 20.0)})
        }
    }
}

/// Factors of lengths, stresses and forces.
const LENGTHS: [&str; 18] = [
    "radius",
    "width",
    "depth",
    "tip_radius",
    "edge_radius",
    "semi_axis_x",
    "semi_axis_y",
    "scale",
    "approach",
    "approaches",
    "case_depth",
    "radius_x",
    "radius_y",
    "length",
    "crown_radius",
    "spacing_x",
    "spacing_y",
    "heights",
];
const STRESSES: [&str; 11] = [
    "young_modulus",
    "yield_stress",
    "tangent_modulus",
    "coefficient",
    "reference_stress",
    "saturation_stress",
    "modulus",
    "torsion",
    "bending",
    "sigma_x",
    "sigma_z",
];

/// Writes a job in metres, pascals and newtons.
fn to_si(value: &mut Value, analysis: &str) {
    let force = if analysis.starts_with("plane") { 1e3 } else { 1.0 };
    let scale_all = |value: &mut Value, factors: &[f64]| scale_numbers(value, factors);
    let Value::Object(fields) = value else {
        if let Value::Array(items) = value {
            for item in items {
                to_si(item, analysis);
            }
        }
        return;
    };
    let is_profile = fields.get("type").is_some_and(|kind| kind == "profile");
    for (key, item) in fields {
        match key.as_str() {
            "points" if is_profile => scale_all(item, &[1e-3, 1e-3]),
            "points" => scale_all(item, &[1.0, 1e6]),
            "over_depth" => scale_all(item, &[1e-3, 1.0]),
            "force" | "forces" => scale_all(item, &[force]),
            key if LENGTHS.contains(&key) => scale_all(item, &[1e-3]),
            key if STRESSES.contains(&key) => scale_all(item, &[1e6]),
            _ => to_si(item, analysis),
        }
    }
}

/// Multiplies numbers, those of pairs by one factor each.
fn scale_numbers(value: &mut Value, factors: &[f64]) {
    match value {
        Value::Number(number) => *value = json!(number.as_f64().unwrap_or(0.0) * factors[0]),
        Value::Array(items) => {
            for (k, item) in items.iter_mut().enumerate() {
                let factors =
                    if item.is_number() && factors.len() > 1 { &factors[k..=k] } else { factors };
                scale_numbers(item, factors);
            }
        }
        _ => {}
    }
}
