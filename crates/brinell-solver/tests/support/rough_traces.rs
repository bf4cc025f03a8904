//! The rough traces that were reported, `y = -x²/100 + amplitude · z` with Gaussian noise z, over
//! -10 to 10 mm. One generator made them one after the other: CPython's `random.Random(5).gauss`.
//! They are too long to be kept.

/// Number of points, amplitude \[mm\], and how many numbers were drawn before.
pub const TRACES: [(usize, f64, usize); 3] =
    [(2001, 1e-4, 0), (8001, 1e-4, 2001), (8001, 5e-4, 10_002)];

/// Points `[x, height]` of a trace \[mm\].
pub fn trace((count, amplitude, drawn): (usize, f64, usize)) -> Vec<[f64; 2]> {
    let mut gauss = Gauss { uniform: MersenneTwister::new(5), second: None };
    for _ in 0..drawn {
        gauss.next();
    }
    (0..count)
        .map(|k| {
            let x = -10.0 + 20.0 * k as f64 / (count - 1) as f64;
            [x, -x * x / 100.0 + amplitude * gauss.next()]
        })
        .collect()
}

/// Normally distributed numbers in pairs, by Box and Muller.
struct Gauss {
    uniform: MersenneTwister,
    second: Option<f64>,
}

impl Gauss {
    fn next(&mut self) -> f64 {
        if let Some(second) = self.second.take() {
            return second;
        }
        let angle = self.uniform.next() * std::f64::consts::TAU;
        let radius = (-2.0 * (1.0 - self.uniform.next()).ln()).sqrt();
        self.second = Some(angle.sin() * radius);
        angle.cos() * radius
    }
}

const SIZE: usize = 624;
const SHIFT: usize = 397;

/// MT19937 of M. Matsumoto and T. Nishimura (1998), initialized by an array of one number as
/// CPython does it.
struct MersenneTwister {
    state: Vec<u32>,
    index: usize,
}

impl MersenneTwister {
    fn new(seed: u32) -> Self {
        let mut state = vec![19_650_218_u32];
        for k in 1..624_u32 {
            let last = state[state.len() - 1];
            state.push(1_812_433_253_u32.wrapping_mul(last ^ (last >> 30)).wrapping_add(k));
        }
        let mixed = |state: &[u32], k: usize, factor: u32| {
            state[k] ^ (state[k - 1] ^ (state[k - 1] >> 30)).wrapping_mul(factor)
        };
        // Once round for each number and once more, the last one standing for the first.
        let mut k = 1;
        for step in 0..2 * SIZE - 1 {
            state[k] = if step < SIZE {
                mixed(&state, k, 1_664_525).wrapping_add(seed)
            } else {
                mixed(&state, k, 1_566_083_941).wrapping_sub(u32::try_from(k).unwrap())
            };
            k += 1;
            if k == SIZE {
                state[0] = state[SIZE - 1];
                k = 1;
            }
        }
        state[0] = 0x8000_0000;
        Self { state, index: SIZE }
    }

    /// Evenly distributed from 0 to 1, with 53 bits.
    fn next(&mut self) -> f64 {
        let [high, low] = [self.word() >> 5, self.word() >> 6].map(f64::from);
        (high * 67_108_864.0 + low) / 9_007_199_254_740_992.0
    }

    fn word(&mut self) -> u32 {
        if self.index == SIZE {
            for k in 0..SIZE {
                let bits =
                    (self.state[k] & 0x8000_0000) | (self.state[(k + 1) % SIZE] & 0x7fff_ffff);
                let odd = if bits & 1 == 1 { 0x9908_b0df } else { 0 };
                self.state[k] = self.state[(k + SHIFT) % SIZE] ^ (bits >> 1) ^ odd;
            }
            self.index = 0;
        }
        let mut word = self.state[self.index];
        self.index += 1;
        word ^= word >> 11;
        word ^= (word << 7) & 0x9d2c_5680;
        word ^= (word << 15) & 0xefc6_0000;
        word ^ (word >> 18)
    }
}
