//! Figures of a load that rolls, in N–mm–MPa.

use super::document::{RuleVerdict, SolvedHardening, TrackVerdict};
use crate::job::Side;
use crate::report::answers::Name;
use crate::solver::method::figures::ROUNDING;
use crate::solver::rolling::{BodyPass, BodyPassErrors, Limit, Pass, PassErrors};

/// A track after its passes.
#[derive(Debug, Clone)]
pub(in crate::report) struct Rolled {
    /// Verdicts by the rules that were solved.
    pub rules: Vec<Ruled>,
    /// Place of the one that is the verdict: the worst.
    pub worst: usize,
    pub friction: f64,
    /// Limits of perfectly plastic bodies, and of kinematic hardening without bound.
    pub limits: [Option<Limit>; 2],
    pub shear_yield_stress: Option<f64>,
    /// The last pass; none before the first has converged.
    pub last: Option<PassFigures>,
}

impl Rolled {
    /// Returns the verdict.
    pub fn worst(&self) -> Option<&Ruled> {
        self.rules.get(self.worst)
    }
}

/// The verdict by one rule of hardening.
#[derive(Debug, Clone)]
pub(in crate::report) struct Ruled {
    pub said: RuleVerdict,
    /// Strain of a steady pass and its error.
    pub rate: Option<f64>,
    pub rate_error: Option<f64>,
    /// Its depth.
    pub depth: Option<f64>,
    /// The body of which it is said; none of both.
    pub body: Option<Side>,
    /// Passes that have converged.
    pub passes: usize,
}

impl Ruled {
    pub const fn verdict(&self) -> TrackVerdict {
        self.said.verdict
    }

    pub const fn hardening(&self) -> SolvedHardening {
        self.said.hardening
    }
}

/// A figure of a pass: its absolute error, and its place `[across, depth]`.
#[derive(Debug, Clone, Copy)]
pub(in crate::report) struct PassFigure {
    pub name: Name,
    pub core: f64,
    pub error: Option<f64>,
    pub place: Option<[f64; 2]>,
    pub is_detail: bool,
}

impl PassFigure {
    const fn new(name: Name, core: f64, error: Option<f64>) -> Self {
        Self { name, core, error, place: None, is_detail: false }
    }

    const fn detail(self) -> Self {
        Self { is_detail: true, ..self }
    }

    /// Puts a strain at its place.
    const fn at(self, across: f64, depth: f64) -> Self {
        let place = if self.core > 0.0 { Some([across, depth]) } else { None };
        Self { place, ..self }
    }

    /// Returns the relative error.
    pub fn bar(&self) -> Option<f64> {
        let bar = self.error? / self.core.abs();
        Some(bar).filter(|bar| bar.is_finite())
    }
}

/// The figures of a pass.
#[derive(Debug, Clone)]
pub(in crate::report) struct PassFigures {
    pub number: usize,
    pub iterations: usize,
    /// Figures that the rows of the contact have too.
    pub contact: Vec<PassFigure>,
    /// Works and resistance.
    pub works: Vec<PassFigure>,
    /// Of each body that can yield.
    pub bodies: [Vec<PassFigure>; 2],
}

impl PassFigures {
    /// `accumulated` is the largest strain of all passes so far in each body.
    pub fn of(
        (number, pass): (usize, &Pass),
        errors: Option<&PassErrors>,
        force: f64,
        accumulated: [f64; 2],
    ) -> Self {
        let error = |of: fn(&PassErrors) -> f64| errors.map(of);
        let work = error(|errors| errors.work);
        let of = PassFigure::new;
        // Rolling force and resistance have the relative error of the plastic work.
        let scaled = |value: f64| work.map(|work| work * (value / pass.plastic_work()).abs());
        let rolling = pass.rolling_force;
        let rolling = if rolling.abs() > ROUNDING * force { rolling } else { 0.0 };
        let mut contact = vec![
            of(Name::PeakPressure, pass.peak_pressure, error(|errors| errors.peak_pressure)),
            of(Name::HalfWidth, pass.half_width(), error(|errors| errors.half_width)),
        ];
        contact
            .extend(pass.half_width_across.map(|across| of(Name::HalfWidthAcross, across, None)));
        contact.extend(
            pass.approach
                .map(|approach| of(Name::Approach, approach, error(|errors| errors.approach))),
        );
        let works = vec![
            of(Name::RollingForce, rolling, scaled(rolling)),
            of(Name::RollingResistance, rolling / force, scaled(rolling / force)),
            of(Name::PassWork, pass.plastic_work(), work).detail(),
            of(Name::PassStoredEnergy, pass.stored_energy(), None).detail(),
            of(Name::TractionWork, pass.work_of_traction, None).detail(),
            of(Name::EnergyGap, pass.energy_gap(), None).detail(),
        ];
        let is_line = pass.half_width_across.is_none();
        let bodies = [0, 1].map(|side| {
            let body = pass.bodies[side].as_ref();
            let errors = errors.and_then(|errors| errors.bodies[side].as_ref());
            body.map_or_else(Vec::new, |body| of_body(body, errors, accumulated[side], is_line))
        });
        Self { number, iterations: pass.iterations, contact, works, bodies }
    }
}

fn of_body(
    body: &BodyPass,
    errors: Option<&BodyPassErrors>,
    accumulated: f64,
    is_line: bool,
) -> Vec<PassFigure> {
    let outlet = &body.outlet;
    let error = |of: fn(&BodyPassErrors) -> f64| errors.map(of);
    let stresses = |k: usize| outlet.on_axis(&outlet.residual).map(move |stress| stress[k]);
    let least = |k: usize| stresses(k).fold(f64::INFINITY, f64::min);
    let most = |k: usize| stresses(k).fold(f64::NEG_INFINITY, f64::max);
    let residual = error(|errors| errors.residual);
    let of = PassFigure::new;
    let (largest, net) = (&body.strain.largest, &body.strain.net);
    let mut figures =
        vec![of(Name::TrackDepth, outlet.groove_depth, error(|errors| errors.groove_depth))];
    if !is_line {
        figures.push(of(Name::PileUp, outlet.pile_up, error(|errors| errors.pile_up)));
    }
    figures.extend([
        of(Name::ForwardDisplacement, outlet.forward, error(|errors| errors.forward)),
        of(Name::PassStrain, largest.value, error(|errors| errors.largest_strain))
            .at(largest.across, largest.depth),
        of(Name::NetStrain, net.value, error(|errors| errors.net_strain))
            .at(net.across, net.depth),
        of(Name::MaxPlasticStrain, accumulated, None),
        of(Name::LeastSigmaX, least(0), residual),
        of(Name::LeastSigmaZ, least(1), residual),
        of(Name::LargestSigmaX, most(0), residual).detail(),
        of(Name::LargestSigmaZ, most(1), residual).detail(),
    ]);
    figures
}
