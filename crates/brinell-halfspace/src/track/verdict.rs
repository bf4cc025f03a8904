//! Whether a track shakes down, closes a cycle or ratchets, from the strains of its passes.
//!
//! `dp` is the largest accumulated plastic strain of a pass, `net` the largest change of the plastic
//! strain over it. With N passes, `x_∞` is Aitken's limit of `x_{N-6}`, `x_{N-3}`, `x_N`:
//! ```text
//! elastic        dp_1 = 0
//! shakes down    dp_N < 1e-3 ε_y,   or   dp_N < 0.9 dp_{N-3} and dp_∞ < 0.15 dp_N
//! closed cycle   |dp_N - dp_{N-3}| < 0.03 dp_N, and  net_N < 0.01 dp_N
//!                                               or   net_N < 0.9 net_{N-3} and net_∞ < 0.15 net_N
//! ratchets       |dp_N - dp_{N-3}| < 0.03 dp_N, and  |net_N - net_{N-3}| < 0.05 net_N
//! ```
//! All but the first two need eight passes. A word counts once three passes running have given it.
//! Accumulated strain that grows is no ratcheting: a closed cycle accumulates in every pass and
//! goes nowhere.
//!
//! Three neighbouring passes would not do: transients of six to eight passes look geometric.

use super::fault::NOTHING;
use super::figures::PassStrain;

/// Passes without which only the largest strains can say anything.
const LEAST_PASSES: usize = 8;
/// Passes between those that are compared.
const APART: usize = 3;
/// Passes that have to agree.
const RUNNING: usize = 3;
/// Ratio of a figure and the one before below which it falls.
const FALLS: f64 = 0.9;
/// Limit of a falling figure over the figure below which the limit is zero.
const TO_ZERO: f64 = 0.15;
/// Relative changes of dp and of net below which they are steady.
const STEADY: f64 = 0.03;
const STEADY_NET: f64 = 0.05;
/// Net over accumulated strain below which a cycle is closed.
const CLOSED: f64 = 0.01;

/// Verdict on a track: elastic, shakedown, closed cycle or ratcheting.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SteadyState {
    /// Nothing yields.
    Elastic,
    /// Plastic flow ends.
    ShakesDown {
        /// Net strain that is still to come.
        remaining: f64,
    },
    /// The material flows in every pass and returns to where it was: plastic shakedown.
    ClosedCycle {
        /// Accumulated strain of a pass, at the surface where the first layer decides.
        strain: f64,
        /// Its change over three passes.
        bar: f64,
    },
    /// Every pass adds a strain.
    Ratchets {
        /// Net strain of a pass, at the surface where the first layer decides.
        rate: f64,
        /// Its change over three passes.
        bar: f64,
    },
    /// More passes are needed.
    Undecided {
        /// Net strain of the last pass.
        net: f64,
    },
}

impl SteadyState {
    /// Passes, or pairs of alternating passes, without which none closes a cycle or ratchets.
    pub const LEAST: usize = LEAST_PASSES + RUNNING - 1;

    /// The verdict of these passes, or pairs of alternating passes, alone. `yield_strain` is
    /// `σ_y/E`.
    pub fn of(passes: &[PassStrain], yield_strain: f64) -> Self {
        let (Some(first), Some(last)) = (passes.first(), passes.last()) else {
            return Self::Undecided { net: 0.0 };
        };
        if first.largest.value <= 0.0 {
            return Self::Elastic;
        }
        let (dp, net) = (last.largest.value, last.net.value);
        let undecided = Self::Undecided { net };
        if dp < NOTHING * yield_strain {
            return Self::ShakesDown { remaining: net };
        }
        if passes.len() < LEAST_PASSES {
            return undecided;
        }
        let three = |value: fn(&PassStrain) -> f64| {
            let of = |back: usize| value(&passes[passes.len() - 1 - back]);
            [of(2 * APART), of(APART), of(0)]
        };
        let (strains, nets) = (three(|p| p.largest.value), three(|p| p.net.value));
        let ends = |[_, before, now]: [f64; 3], limit: Option<f64>| {
            now < FALLS * before && limit.is_some_and(|limit| limit < TO_ZERO * now)
        };
        let (limit_of_net, change) = (aitken(nets), (strains[2] - strains[1]).abs());
        if ends(strains, aitken(strains)) {
            let remaining = (net - limit_of_net.unwrap_or(0.0)).abs();
            return Self::ShakesDown { remaining };
        }
        if change < STEADY * dp {
            if net < CLOSED * dp || ends(nets, limit_of_net) {
                return Self::ClosedCycle { strain: last.largest.limit(), bar: change };
            }
            let bar = (net - nets[1]).abs();
            if bar < STEADY_NET * net {
                return Self::Ratchets { rate: last.net.limit(), bar };
            }
        }
        undecided
    }

    /// The verdict of these passes once the last three agree; `Undecided` before.
    pub fn that_counts(passes: &[PassStrain], yield_strain: f64) -> Self {
        let last = Self::of(passes, yield_strain);
        let agrees = |back: usize| {
            let n = passes.len().checked_sub(back).filter(|n| *n > 0)?;
            let earlier = Self::of(&passes[..n], yield_strain);
            (std::mem::discriminant(&earlier) == std::mem::discriminant(&last)).then_some(())
        };
        // Without yield, one pass is like the next.
        if last == Self::Elastic || (1..RUNNING).all(|back| agrees(back).is_some()) {
            return last;
        }
        Self::Undecided { net: passes.last().map_or(0.0, |pass| pass.net.value) }
    }
}

/// Limit of a geometric sequence a, b, c; `None` if its differences do not shrink.
fn aitken([a, b, c]: [f64; 3]) -> Option<f64> {
    let (first, second) = (b - a, c - b);
    (second.abs() < first.abs()).then(|| c - second * second / (second - first))
}

#[cfg(test)]
mod tests {
    use super::super::figures::AtDepth;
    use super::*;

    const YIELD: f64 = 500.0 / 210_000.0;

    fn passes(n: i32, strain: impl Fn(i32) -> f64, net: impl Fn(i32) -> f64) -> Vec<PassStrain> {
        let at = |value: f64| AtDepth { value, ..AtDepth::default() };
        (0..n).map(|i| PassStrain { largest: at(strain(i)), net: at(net(i)) }).collect()
    }

    fn of(n: i32, strain: impl Fn(i32) -> f64, net: impl Fn(i32) -> f64) -> SteadyState {
        SteadyState::that_counts(&passes(n, strain, net), YIELD)
    }

    #[test]
    fn words_of_sequences_that_are_known() {
        assert_eq!(of(1, |_| 0.0, |_| 0.0), SteadyState::Elastic);
        let falls = |i: i32| 1e-3 * 0.7f64.powi(i);
        assert!(matches!(of(12, falls, falls), SteadyState::ShakesDown { .. }));
        let steady = |_: i32| 2e-3;
        assert!(matches!(of(12, steady, falls), SteadyState::ClosedCycle { .. }));
        let creeps = |i: i32| 4e-4 + 1e-3 * 0.5f64.powi(i);
        match of(12, steady, creeps) {
            SteadyState::Ratchets { rate, bar } => {
                assert!((rate - 4e-4).abs() < 1e-6 && bar < 1e-5, "{rate} {bar}");
            }
            other => panic!("{other:?}"),
        }
        // Too few passes, and a figure that rises.
        assert!(matches!(of(9, steady, creeps), SteadyState::Undecided { .. }));
        let rises = |i: i32| 1e-4 * 1.1f64.powi(i);
        assert!(matches!(of(12, steady, rises), SteadyState::Undecided { .. }));
        assert!(matches!(of(0, steady, steady), SteadyState::Undecided { .. }));
    }

    /// A last small strain ends the matter in any pass, but not before three have been small.
    #[test]
    fn a_word_counts_after_three_passes() {
        let strain = |i: i32| if i == 0 { 1e-3 } else { 1e-7 };
        let net = |i: i32| 0.5 * strain(i);
        assert!(matches!(of(3, strain, net), SteadyState::Undecided { .. }));
        assert!(matches!(of(4, strain, net), SteadyState::ShakesDown { .. }));
    }

    #[test]
    fn a_limit_of_what_does_not_converge_is_none() {
        assert_eq!(aitken([1.0, 2.0, 3.0]), None);
        assert_eq!(aitken([1.0, 1.0, 1.0]), None);
        assert!((aitken([9.0, 5.0, 3.0]).unwrap() - 1.0).abs() < 1e-14);
    }
}
