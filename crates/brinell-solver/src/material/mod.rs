//! Deformation (total, Hencky) theory of plasticity.
//!
//! Split the strain into its mean and its deviator `e`, with the equivalent strain `ε_q = √(2/3 e:e)`. The
//! response to the mean stays elastic. The deviatoric stress is
//!
//! ```text
//! s = 2 G_s e,   G_s = q / (3 ε_q),   ε_q = q / (3G) + ε_p(q)
//! ```
//!
//! with the equivalent (von Mises) stress `q` and the plastic strain `ε_p(q)` of the uniaxial curve. `G_s`, the
//! *secant* shear modulus, is what is left of `G` at that point. The *initial stress* is what the elastic law
//! says too much, `σ_0 = D_e ε - σ = 2 (G - G_s) e`; it is deviatoric.
//!
//! The theory knows no unloading. It is exact where all stress components grow in proportion.
//!
//! # Reference
//! H. Hencky, *Zur Theorie plastischer Deformationen*, ZAMM 4 (1924) 323–334.

mod hardening;
pub mod laws;
mod point;
mod tangent;

pub use hardening::{HardeningLaw, UniaxialCurve};
pub use point::{OutOfPlane, PointLaw, PointState};
pub use tangent::{Moduli, ReferenceModuli, Softened};

/// Equivalent strain `ε_q = √(2/3 e:e)` of a deviator `[e_xx, e_yy, e_zz, γ_xy]`.
#[inline]
pub fn equivalent_strain(deviator: [f64; 4]) -> f64 {
    let [x, y, z, g] = deviator;
    (2.0 / 3.0 * (x * x + y * y + z * z + 0.5 * g * g)).sqrt()
}

/// Von Mises stress `q = √(3/2 s:s)` of a stress `[σ_xx, σ_yy, σ_zz, τ_xy]` \[MPa\].
pub fn von_mises(stress: [f64; 4]) -> f64 {
    let [x, y, z, t] = stress;
    (0.5 * ((x - y).powi(2) + (y - z).powi(2) + (z - x).powi(2)) + 3.0 * t * t).sqrt()
}
