//! The moment under which a roller tilts.

/// The moment of a job along y of the fields.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PrescribedMoment {
    /// About the middle, positive where the half at positive y bears more \[N mm\].
    pub moment: f64,
    /// The force from which on it is whole; in proportion to the force below \[N\].
    pub whole_from: f64,
    /// Half the length of the roller \[mm\].
    pub half_length: f64,
}

impl PrescribedMoment {
    /// Under a force \[N mm\].
    pub fn under(self, force: f64) -> f64 {
        self.moment * (force / self.whole_from).min(1.0)
    }

    /// Returns the deviation of a moment from the prescribed one, over force and half the length.
    pub fn missing(self, moment: f64, force: f64) -> f64 {
        if force <= 0.0 {
            return 0.0;
        }
        (moment - self.under(force)) / (force * self.half_length)
    }
}
