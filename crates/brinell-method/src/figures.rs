//! The scalar figures of a contact. A figure is one row of the table `figures!` here: its
//! identifier, its quantity and its type. The row makes its member of [`Figures`], its name in the
//! enumeration [`Figure`], and its place in every list of values, differences and error bars.

use crate::words::Quantity;

/// Difference of figures that are alike, over their size.
pub const ROUNDING: f64 = 1e-9;

macro_rules! figures {
    (
        contact { $($(#[$contact_doc:meta])* $contact:ident $Contact:ident $contact_quantity:ident $contact_type:ty,)* }
        body { $($(#[$body_doc:meta])* $body:ident $Body:ident $body_quantity:ident $body_type:ty,)* }
    ) => {
        /// A scalar figure of the contact, or of one body.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Figure {
            $($(#[$contact_doc])* $Contact,)*
            $($(#[$body_doc])* $Body,)*
        }

        impl Figure {
            /// All figures, those of the contact first.
            pub const ALL: &'static [Self] = &[$(Self::$Contact,)* $(Self::$Body,)*];
            /// Number of figures of the contact.
            pub const OF_CONTACT: usize = [$(Self::$Contact,)*].len();
            /// Number of figures of a body.
            pub const OF_BODY: usize = [$(Self::$Body,)*].len();

            /// Returns the identifier, in snake case.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$Contact => stringify!($contact),)*
                    $(Self::$Body => stringify!($body),)*
                }
            }

            /// Returns the physical quantity; a force is that of the whole contact.
            pub const fn quantity(self) -> Quantity {
                match self {
                    $(Self::$Contact => Quantity::$contact_quantity,)*
                    $(Self::$Body => Quantity::$body_quantity,)*
                }
            }
        }

        /// The measured figures of a contact. An engine names all of them: it measures a figure of
        /// type `f64`, and a figure of type `Option<f64>` that it does not measure is `None`.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct Figures {
            $($(#[$contact_doc])* pub $contact: $contact_type,)*
            /// Upper and lower body; `None` of a rigid one and of one whose fields are not computed.
            pub bodies: [Option<BodyFigures>; 2],
        }

        /// The measured figures of one body.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct BodyFigures {
            $($(#[$body_doc])* pub $body: $body_type,)*
        }

        impl Figures {
            /// Returns all values.
            pub fn values(&self) -> Values {
                let [upper, lower] = self.bodies;
                Values([
                    $(self.$contact.into(),)*
                    $(upper.and_then(|body| body.$body.into()),)*
                    $(lower.and_then(|body| body.$body.into()),)*
                ])
            }
        }
    };
}

figures! {
    contact {
        /// Largest contact pressure \[MPa\].
        peak_pressure PeakPressure Stress f64,
        /// Contact pressure in the middle of the contact; of a roller the largest across its middle,
        /// none of heights \[MPa\].
        middle_pressure MiddlePressure Stress Option<f64>,
        /// Half-width; in three dimensions the semi-axis along x \[mm\].
        half_width HalfWidth Length f64,
        /// Semi-axis along y; only in three dimensions \[mm\].
        semi_axis_y SemiAxisY Length Option<f64>,
        /// Area of the contact; only in three dimensions \[mm²\].
        contact_area ContactArea Area Option<f64>,
        /// Area of the contact over that of the surface; only of heights \[1\].
        contact_ratio ContactRatio Ratio Option<f64>,
        /// Approach \[mm\].
        approach Approach Length f64,
        /// Contact force, of both sides of the axis \[N/mm, or N\].
        force Force Force f64,
    }
    body {
        /// Largest equivalent plastic strain at a point \[1\].
        max_plastic_strain MaxPlasticStrain Strain f64,
        /// Mean equivalent plastic strain over the plastic area \[1\].
        mean_plastic_strain MeanPlasticStrain Strain Option<f64>,
        /// Area of the section that has yielded \[mm²\].
        plastic_area PlasticArea Area Option<f64>,
        /// Depth down to which there is plastic strain; `None` without plastic strain \[mm\].
        plastic_depth PlasticDepth Length Option<f64>,
        /// Depth of the deepest point of the surface below the undeformed one \[mm\].
        dent Dent Length f64,
        /// Height of the highest point of the surface above the undeformed one \[mm\].
        pile_up PileUp Length f64,
        /// Least stress along the surface on the normal below the middle of the contact \[MPa\].
        least_stress LeastStress Stress Option<f64>,
        /// Largest von Mises stress over the strength there, that of the surface being 1 \[MPa\].
        largest_von_mises LargestVonMises Stress Option<f64>,
    }
}

impl Figures {
    /// Returns the semi-axes along x and y; those of a circle where only one is measured \[mm\].
    pub fn semi_axes(&self) -> [f64; 2] {
        [self.half_width, self.semi_axis_y.unwrap_or(self.half_width)]
    }
}

/// A number for each figure: contact, upper body, lower body. `None` where there is none, which is
/// the default.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Values([Option<f64>; Self::COUNT]);

impl Values {
    /// Number of values, with the figures of a body twice.
    pub const COUNT: usize = Figure::OF_CONTACT + 2 * Figure::OF_BODY;

    /// Returns the value of a figure, of a body that of one side.
    pub const fn get(&self, figure: Figure, side: usize) -> Option<f64> {
        self.0[figure.at(side)]
    }

    /// Returns the value of a figure, of bodies the larger one.
    pub fn largest(&self, figure: Figure) -> Option<f64> {
        [0, 1].into_iter().filter_map(|side| self.get(figure, side)).reduce(f64::max)
    }

    /// Sets the value of a figure, of a body that of one side.
    pub fn set(&mut self, figure: Figure, side: usize, value: impl Into<Option<f64>>) {
        self.0[figure.at(side)] = value.into();
    }

    /// Computes a new value from each that there is.
    #[must_use]
    pub fn map(&self, new: impl Fn(Figure, usize, f64) -> f64) -> Self {
        let mut values = *self;
        for (figure, side) in Figure::ALL.iter().flat_map(|figure| [(*figure, 0), (*figure, 1)]) {
            let place = figure.at(side);
            values.0[place] = self.0[place].map(|value| new(figure, side, value));
        }
        values
    }

    /// Combines values that both have.
    #[must_use]
    pub fn zip(&self, other: &Self, combine: impl Fn(f64, f64) -> f64) -> Self {
        Self(std::array::from_fn(|k| Some(combine(self.0[k]?, other.0[k]?))))
    }

    /// Combines values that one has. The other one is 0.
    #[must_use]
    pub fn with(&self, other: &Self, combine: impl Fn(f64, f64) -> f64) -> Self {
        Self(std::array::from_fn(|k| match (self.0[k], other.0[k]) {
            (None, None) => None,
            (a, b) => Some(combine(a.unwrap_or(0.0), b.unwrap_or(0.0))),
        }))
    }
}

impl Figure {
    /// Returns whether each body has its own value.
    pub const fn is_of_body(self) -> bool {
        self as usize >= Self::OF_CONTACT
    }

    /// Returns the place among the [`values`](Figures::values). Figures of the contact have the
    /// same place for both sides.
    pub const fn at(self, side: usize) -> usize {
        let place = self as usize;
        if self.is_of_body() { place + side * Self::OF_BODY } else { place }
    }
}

/// A set of figures, each of a body for itself.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct FigureSet([bool; Values::COUNT]);

impl FigureSet {
    /// All figures.
    pub const ALL: Self = Self([true; Values::COUNT]);

    /// Returns the set of some figures, of both bodies.
    pub fn of(figures: &[Figure]) -> Self {
        Self::of_bodies(figures, [true; 2])
    }

    /// Returns the set of some figures, those of bodies for the chosen sides.
    pub fn of_bodies(figures: &[Figure], sides: [bool; 2]) -> Self {
        let mut set = Self::default();
        for figure in figures {
            for side in (0..2).filter(|side| sides[*side] || !figure.is_of_body()) {
                set.0[figure.at(side)] = true;
            }
        }
        set
    }

    /// Returns the set of all figures but one of the contact.
    pub fn all_but(figure: Figure) -> Self {
        let mut set = Self::ALL;
        set.0[figure.at(0)] = false;
        set
    }

    /// Returns the figures of either set.
    #[must_use]
    pub fn with(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] || other.0[k]))
    }

    /// Returns the figures of both sets.
    #[must_use]
    pub fn within(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] && other.0[k]))
    }

    /// Returns whether no figure is in the set.
    pub fn is_empty(&self) -> bool {
        self.0.iter().all(|has| !has)
    }

    /// Returns whether a figure is in the set. The side counts for figures of a body.
    pub fn has(&self, figure: Figure, side: usize) -> bool {
        self.0[figure.at(side)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BODY: BodyFigures = BodyFigures {
        max_plastic_strain: 0.01,
        mean_plastic_strain: None,
        plastic_area: None,
        plastic_depth: None,
        dent: 0.0,
        pile_up: 0.0,
        least_stress: Some(-3.0),
        largest_von_mises: None,
    };

    #[test]
    fn a_figure_that_is_not_measured_has_no_value() {
        let figures = Figures {
            peak_pressure: 2.0,
            middle_pressure: None,
            half_width: 1.0,
            semi_axis_y: None,
            contact_area: None,
            contact_ratio: None,
            approach: 0.0,
            force: 5.0,
            bodies: [None, Some(BODY)],
        };
        let values = figures.values();
        assert_eq!(values.get(Figure::Force, 1), Some(5.0));
        assert_eq!(values.get(Figure::Approach, 0), Some(0.0));
        assert_eq!([0, 1].map(|side| values.get(Figure::Dent, side)), [None, Some(0.0)]);
        assert_eq!(values.get(Figure::PlasticDepth, 1), None);
        assert_eq!(Figure::ALL.len(), Figure::OF_CONTACT + Figure::OF_BODY);
        assert_eq!(Figure::LargestVonMises.name(), "largest_von_mises");
    }

    #[test]
    fn values_combine_where_both_or_one_has_them() {
        let mut left = Values::default();
        left.set(Figure::Dent, 1, 2.0);
        let mut right = left;
        right.set(Figure::Force, 0, 3.0);
        let product = left.zip(&right, |a, b| a * b);
        assert_eq!(product.get(Figure::Dent, 1), Some(4.0));
        assert_eq!(product.get(Figure::Force, 0), None);
        assert_eq!(left.with(&right, |a, b| a + b).get(Figure::Force, 0), Some(3.0));
        let sides = right.map(|_, side, value| value + side as f64);
        assert_eq!((sides.get(Figure::Dent, 1), sides.get(Figure::Dent, 0)), (Some(3.0), None));
    }

    #[test]
    fn sets_tell_the_bodies_apart() {
        let set = FigureSet::of_bodies(&[Figure::Dent, Figure::Force], [false, true]);
        assert!(set.has(Figure::Dent, 1) && !set.has(Figure::Dent, 0));
        assert!(set.has(Figure::Force, 0) && !set.has(Figure::Approach, 0));
        assert_eq!(set.with(FigureSet::ALL), FigureSet::ALL);
    }
}
