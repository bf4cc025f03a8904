//! Flow along streamlines: what a body remembers that passes under a load at rest.
//!
//! In the frame of a load that moves in +x over a uniform track, a steady pass is stationary.
//! Material enters at the front, the last of the columns, with the memory that the passes before
//! have left, and leaves at the back. It meets the columns one after the other, so that column i
//! goes through the straight path
//! ```text
//! ds = T_i - T_{i+1},   T_i = dev σ_i + 2G (ε_p,i - ε_p,in),   T_N = dev σ_in
//! ```
//! T is the trial of the plastic law and contains no stress that the law itself has returned. The
//! path is thus driven by strain. Differences from the integrated stress would hand the errors of
//! an iterate on from column to column, and the iteration would diverge.

use std::sync::Arc;

use crate::{FlowPlasticity, Flowing};

/// Components of a deviator that does not depend on y: xx, yy, zz, xz.
const PLANE: usize = 4;
/// Those of any deviator: xx, yy, zz, xy, xz, yz.
const SPACE: usize = 6;

/// Components of a deviator of a line that are given: xx, zz, xz.
pub type Rows<'a> = [&'a [f64]; 3];

/// Deviators of D components, of which R are given and determine the others.
pub trait Deviators<const D: usize, const R: usize> {
    /// The components that change their sign with x.
    const ODD: &'static [usize];

    /// The deviator of the components that are given.
    fn whole(given: [f64; R]) -> [f64; D];

    /// The components that are given.
    fn given(whole: [f64; D]) -> [f64; R];
}

/// Coordinates x along the travel, y across it and z into the depth.
#[derive(Debug, Clone, Copy)]
pub struct TrackFrame;

impl Deviators<PLANE, 3> for TrackFrame {
    const ODD: &'static [usize] = &[3];

    #[inline(always)]
    fn whole([xx, zz, xz]: [f64; 3]) -> [f64; PLANE] {
        [xx, -xx - zz, zz, xz]
    }

    #[inline(always)]
    fn given([xx, _, zz, xz]: [f64; PLANE]) -> [f64; 3] {
        [xx, zz, xz]
    }
}

impl Deviators<SPACE, 5> for TrackFrame {
    const ODD: &'static [usize] = &[3, 4];

    #[inline(always)]
    fn whole([xx, yy, xy, xz, yz]: [f64; 5]) -> [f64; SPACE] {
        [xx, yy, -xx - yy, xy, xz, yz]
    }

    #[inline(always)]
    fn given([xx, yy, _, xy, xz, yz]: [f64; SPACE]) -> [f64; 5] {
        [xx, yy, xy, xz, yz]
    }
}

/// Parts into which the path from one column to the next is divided. With 1, 2 and 6 parts the
/// groove and the strains of a pass agree within 0.3 %.
const PARTS: u32 = 2;

/// The plastic law of the rows of a track, with what the rows remember. x is the direction of
/// travel, z the depth.
///
/// A row is all columns at one depth, and in three dimensions at one y. Deviators have D
/// components, of which R are given: `xx yy zz xz` by `xx zz xz` of a line, where the rows are its
/// layers, and `xx yy zz xy xz yz` by `xx yy xy xz yz` in three dimensions.
pub trait StreamLaw<const D: usize = PLANE, const R: usize = 3>:
    std::fmt::Debug + Send + Sync
{
    /// Number of rows.
    fn n_rows(&self) -> usize;

    /// Follows a row from the front, the last column, to the back.
    ///
    /// `inlet` is the stress deviator before the front, `trial` the T of the columns \[MPa\].
    /// Writes `2G Δε` of each column \[MPa\] into `into`, and the accumulated plastic strain that
    /// the column adds into `strain`. Returns whether any column flows. What the row will then
    /// remember is kept until [`accept`](Self::accept).
    fn follow(
        &mut self,
        row: usize,
        inlet: [f64; D],
        trial: [&[f64]; R],
        into: [&mut [f64]; R],
        strain: &mut [f64],
    ) -> bool;

    /// Takes all rows back to what they remember at the front, as if nothing flowed.
    fn rest(&mut self);

    /// Accepts what the rows remember at the back: the inlet of the next pass.
    fn accept(&mut self);

    /// Changes the direction of x: components xy and xz change their sign.
    fn mirror(&mut self);

    /// Accumulated plastic strain of a row at the front.
    fn accumulated(&self, row: usize) -> f64;

    /// Yield stress of a row at the front \[MPa\].
    fn yield_stress(&self, row: usize) -> f64;

    /// Backstress of a row at the front, the sum of all terms \[MPa\].
    fn backstress(&self, row: usize) -> [f64; D];

    /// `∫σ:dε_p` of all passes accepted \[MPa\], and the part of it that the backstress stores.
    fn plastic_work(&self, row: usize) -> [f64; 2];

    /// `∫σ:dε_p` of the last stream through a row \[MPa\].
    fn work_of_pass(&self, row: usize) -> f64;

    /// Yield stress that a row can reach by hardening of all kinds \[MPa\]; infinite without a
    /// bound.
    fn largest_stress(&self, row: usize) -> f64;
}

/// Rows that yield by flow theory with N backstress terms, with deviators of D components.
#[derive(Debug, Clone)]
pub struct StreamOfLayers<const N: usize, const D: usize = PLANE> {
    models: Vec<Arc<FlowPlasticity<N>>>,
    inlet: Vec<Memory<N, D>>,
    outlet: Vec<Memory<N, D>>,
}

/// The internal variables of a row beside its plastic strain.
#[derive(Debug, Clone, Copy)]
struct Memory<const N: usize, const D: usize> {
    accumulated: f64,
    backstress: [[f64; D]; N],
    plastic_work: f64,
}

impl<const N: usize, const D: usize> StreamOfLayers<N, D> {
    /// Rows of these materials, at rest.
    pub fn new(models: Vec<Arc<FlowPlasticity<N>>>) -> Self {
        let rest = Memory { accumulated: 0.0, backstress: [[0.0; D]; N], plastic_work: 0.0 };
        let inlet = vec![rest; models.len()];
        Self { models, outlet: inlet.clone(), inlet }
    }
}

impl<const N: usize, const D: usize, const R: usize> StreamLaw<D, R> for StreamOfLayers<N, D>
where
    TrackFrame: Deviators<D, R>,
{
    fn n_rows(&self) -> usize {
        self.models.len()
    }

    fn follow(
        &mut self,
        row: usize,
        inlet: [f64; D],
        given: [&[f64]; R],
        mut into: [&mut [f64]; R],
        strain: &mut [f64],
    ) -> bool {
        let Memory { accumulated, backstress, plastic_work } = self.inlet[row];
        let start = Flowing { stress: inlet, accumulated, backstress, plastic_work };
        let mut last = inlet;
        let columns = (0..strain.len()).rev();
        let steps = columns.map(|i| {
            let trial = TrackFrame::whole(given.map(|row| row[i]));
            let step = std::array::from_fn(|k| trial[k] - last[k]);
            last = trial;
            (i, step)
        });
        let mut flows = false;
        let end = self.models[row].stream(start, steps, PARTS, |i, initial, dp| {
            flows = true;
            for (row, value) in into.iter_mut().zip(TrackFrame::given(initial)) {
                row[i] = value;
            }
            strain[i] = dp;
        });
        self.outlet[row] = Memory {
            accumulated: end.accumulated,
            backstress: end.backstress,
            plastic_work: end.plastic_work,
        };
        flows
    }

    fn rest(&mut self) {
        self.outlet.copy_from_slice(&self.inlet);
    }

    fn accept(&mut self) {
        self.inlet.copy_from_slice(&self.outlet);
    }

    fn mirror(&mut self) {
        for memory in self.inlet.iter_mut().chain(&mut self.outlet) {
            for term in &mut memory.backstress {
                for k in TrackFrame::ODD {
                    term[*k] = -term[*k];
                }
            }
        }
    }

    fn accumulated(&self, row: usize) -> f64 {
        self.inlet[row].accumulated
    }

    fn yield_stress(&self, row: usize) -> f64 {
        self.models[row].mapping().law().stress(self.inlet[row].accumulated)
    }

    fn backstress(&self, row: usize) -> [f64; D] {
        std::array::from_fn(|k| self.inlet[row].backstress.iter().map(|term| term[k]).sum())
    }

    fn plastic_work(&self, row: usize) -> [f64; 2] {
        let Memory { plastic_work, backstress, .. } = &self.inlet[row];
        [*plastic_work, self.models[row].backstress_energy(backstress)]
    }

    fn work_of_pass(&self, row: usize) -> f64 {
        self.outlet[row].plastic_work - self.inlet[row].plastic_work
    }

    fn largest_stress(&self, row: usize) -> f64 {
        self.models[row].largest_stress()
    }
}

impl<const N: usize> FlowPlasticity<N> {
    /// Takes steps of the trial stress deviator one after the other, each a number and a step
    /// \[MPa\]. Calls `flowed` with the number, `2G Δε` \[MPa\] and Δp of the steps that flow.
    /// Returns the end.
    pub fn stream<const D: usize>(
        &self,
        mut now: Flowing<N, D>,
        steps: impl Iterator<Item = (usize, [f64; D])>,
        parts: u32,
        mut flowed: impl FnMut(usize, [f64; D], f64),
    ) -> Flowing<N, D> {
        for (i, step) in steps {
            let trial: [f64; D] = std::array::from_fn(|k| now.stress[k] + step[k]);
            match self.flow_along(now, step, parts) {
                Some(end) if end.accumulated > now.accumulated => {
                    let initial = std::array::from_fn(|k| trial[k] - end.stress[k]);
                    flowed(i, initial, end.accumulated - now.accumulated);
                    now = end;
                }
                _ => now.stress = trial,
            }
        }
        now
    }

    /// Returns the yield stress in one direction that isotropic and kinematic hardening can reach
    /// together, `max q + Σ C_i/γ_i` \[MPa\]; infinite without a bound. Larger stresses have no
    /// equilibrium, as a traction `|μ| p` above `1/√3` of it.
    pub fn largest_stress(&self) -> f64 {
        self.mapping().law().largest_stress()
            + self.backstress_terms().iter().map(crate::BackstressTerm::largest).sum::<f64>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hardening::tests::{STEEL, laws};
    use crate::hardening::{StraightLine, Voce};
    use crate::{BackstressTerm, HardeningLaw, OutOfPlane, ReturnMapping};

    fn model<const N: usize>(
        law: Arc<dyn HardeningLaw>,
        terms: [BackstressTerm; N],
    ) -> Arc<FlowPlasticity<N>> {
        let mapping = ReturnMapping::new(law, STEEL.shear);
        Arc::new(FlowPlasticity::new(STEEL, mapping, terms, OutOfPlane::Strained))
    }

    /// A layer under a shear stress that rises and falls over the columns.
    fn follow(law: &mut dyn StreamLaw, amplitude: f64) -> (bool, Vec<f64>, Vec<f64>) {
        let n = 40;
        let xz: Vec<f64> = (0..n)
            .map(|i| amplitude * (0.05 * std::f64::consts::PI * f64::from(i)).sin())
            .collect();
        let zero = vec![0.0; xz.len()];
        let mut into = [zero.clone(), zero.clone(), zero.clone()];
        let mut strain = zero.clone();
        let [a, b, c] = &mut into;
        let flows = law.follow(0, [0.0; 4], [&zero, &zero, &xz], [a, b, c], &mut strain);
        (flows, into[2].clone(), strain)
    }

    /// `Δε_xz` over the columns and Δp are those of a bar in shear: nothing in the elastic range,
    /// and of one perfectly plastic cycle twice the excess over k there and back.
    #[test]
    fn a_perfectly_plastic_layer_flows_by_the_excess() {
        let law =
            Arc::new(StraightLine { yield_stress: 3f64.sqrt() * 100.0, plastic_modulus: 0.0 });
        let mut layer = StreamOfLayers::<0>::new(vec![model(law, [])]);
        let (flows, change, strain) = follow(&mut layer, 99.0);
        assert!(!flows && change.iter().chain(&strain).all(|x| *x == 0.0));
        let (flows, change, strain) = follow(&mut layer, 150.0);
        assert!(flows);
        // From the front: down to -150 (50 beyond -k), up to 150 (100 beyond +k), back to 0.
        let total: f64 = change.iter().sum();
        assert!((total - 50.0).abs() < 1e-9, "{total}");
        let absolute: f64 = change.iter().map(|x| x.abs()).sum();
        assert!((absolute - 150.0).abs() < 1e-9, "{absolute}");
        let p: f64 = strain.iter().sum();
        assert!((p - absolute / (STEEL.shear * 3f64.sqrt())).abs() < 1e-12, "{p}");
        layer.accept();
        assert!((layer.accumulated(0) - p).abs() < 1e-15);
        assert!((layer.plastic_work(0)[0] - 100.0 * absolute / STEEL.shear).abs() < 1e-6);
    }

    /// The law remembers nothing of an iterate that was not accepted, and mirrored twice is as it
    /// was.
    #[test]
    fn only_what_is_accepted_is_remembered() {
        let terms = [BackstressTerm { modulus: 40_000.0, rate: 200.0 }];
        for law in laws() {
            let mut layer = StreamOfLayers::<1>::new(vec![model(law, terms)]);
            let first = follow(&mut layer, 900.0);
            let again = follow(&mut layer, 900.0);
            assert_eq!(first, again);
            layer.accept();
            let kept = layer.backstress(0);
            layer.mirror();
            assert_eq!(layer.backstress(0)[3].to_bits(), (-kept[3]).to_bits());
            layer.mirror();
            assert!(layer.backstress(0).iter().zip(kept).all(|(a, b)| a.to_bits() == b.to_bits()));
            assert!(layer.yield_stress(0) > 0.0 && kept[3] != 0.0);
        }
    }

    #[test]
    fn largest_stress_counts_hardening_of_both_kinds() {
        let voce = || Arc::new(Voce { yield_stress: 300.0, saturation_stress: 400.0, rate: 10.0 });
        let term = |modulus: f64, rate: f64| BackstressTerm { modulus, rate };
        let chaboche = model(voce(), [term(40_000.0, 200.0), term(0.0, 0.0)]);
        assert_eq!(chaboche.largest_stress().to_bits(), 600f64.to_bits());
        assert!(model(voce(), [term(1.0, 0.0)]).largest_stress().is_infinite());
        assert_eq!(model(voce(), []).largest_stress().to_bits(), 400f64.to_bits());
    }
}
