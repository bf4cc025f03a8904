//! The scalar figures of a contact. A figure is one row of the table `figures!` here: its
//! identifier, its quantity and its home in a result: a `member` of its own, or an `answer` alone,
//! which needs nothing else to be shown. The row makes its member of [`Figures`], its name in the
//! enumeration [`Figure`], and its place in every list of values, differences and error bars.

use crate::words::Quantity;

macro_rules! home {
    (member) => {
        true
    };
    (answer) => {
        false
    };
}

macro_rules! figures {
    (
        contact { $($(#[$contact_doc:meta])* $contact:ident $Contact:ident $contact_quantity:ident $contact_home:ident,)* }
        body { $($(#[$body_doc:meta])* $body:ident $Body:ident $body_quantity:ident $body_home:ident,)* }
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

            /// Returns whether a result has a member of its own for the figure. Other figures are
            /// answers only.
            pub const fn has_member(self) -> bool {
                match self {
                    $(Self::$Contact => home!($contact_home),)*
                    $(Self::$Body => home!($body_home),)*
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

        /// The figures of a contact, or one number for each of them.
        #[derive(Debug, Clone, Copy, Default, PartialEq)]
        pub struct Figures {
            $($(#[$contact_doc])* pub $contact: f64,)*
            /// Upper and lower body; zeros of a rigid one.
            pub bodies: [BodyFigures; 2],
        }

        /// The figures of one body, or one number for each of them.
        #[derive(Debug, Clone, Copy, Default, PartialEq)]
        pub struct BodyFigures {
            $($(#[$body_doc])* pub $body: f64,)*
        }

        impl Figures {
            /// Returns all values: contact, upper body, lower body.
            pub fn values(&self) -> [f64; Self::COUNT] {
                let [upper, lower] = self.bodies;
                let all = [$(self.$contact,)* $(upper.$body,)* $(lower.$body,)*];
                all
            }

            /// Makes figures of their values, the inverse of [`values`](Self::values).
            pub fn of(values: [f64; Self::COUNT]) -> Self {
                let mut values = values.into_iter();
                let mut next = || values.next().unwrap_or_default();
                Self {
                    $($contact: next(),)*
                    bodies: std::array::from_fn(|_| BodyFigures { $($body: next(),)* }),
                }
            }
        }
    };
}

figures! {
    contact {
        /// Largest contact pressure \[MPa\].
        peak_pressure PeakPressure Stress member,
        /// Contact pressure in the middle of the contact; of a roller the largest across its middle,
        /// none of heights \[MPa\].
        middle_pressure MiddlePressure Stress member,
        /// Half-width; in three dimensions the semi-axis along x \[mm\].
        half_width HalfWidth Length member,
        /// Semi-axis along y; only in three dimensions \[mm\].
        semi_axis_y SemiAxisY Length member,
        /// Area of the contact; only in three dimensions \[mm²\].
        contact_area ContactArea Area member,
        /// Approach \[mm\].
        approach Approach Length member,
        /// Contact force, of both sides of the axis \[N/mm, or N\].
        force Force Force member,
    }
    body {
        /// Largest equivalent plastic strain at a point \[1\].
        max_plastic_strain MaxPlasticStrain Strain member,
        /// Mean equivalent plastic strain over the plastic area \[1\].
        mean_plastic_strain MeanPlasticStrain Strain member,
        /// Area of the section that has yielded \[mm²\].
        plastic_area PlasticArea Area member,
        /// Depth down to which there is plastic strain \[mm\].
        plastic_depth PlasticDepth Length answer,
        /// Depth of the deepest point of the surface below the undeformed one \[mm\].
        dent Dent Length member,
        /// Height of the highest point of the surface above the undeformed one \[mm\].
        pile_up PileUp Length member,
        /// Least stress along the surface on the normal below the middle of the contact \[MPa\].
        least_stress LeastStress Stress member,
        /// Largest von Mises stress over the strength there, that of the surface being 1 \[MPa\].
        largest_von_mises LargestVonMises Stress member,
    }
}

impl Figures {
    /// Number of values, with the figures of a body twice.
    pub const COUNT: usize = Figure::OF_CONTACT + 2 * Figure::OF_BODY;

    /// Makes figures of a value for each figure and side.
    pub fn by(value: impl Fn(Figure, usize) -> f64) -> Self {
        let mut values = [0.0; Self::COUNT];
        for (figure, side) in Figure::ALL.iter().flat_map(|figure| [(*figure, 0), (*figure, 1)]) {
            values[figure.at(side)] = value(figure, side);
        }
        Self::of(values)
    }

    /// Returns the semi-axes along x and y \[mm\].
    pub const fn semi_axes(&self) -> [f64; 2] {
        [self.half_width, self.semi_axis_y]
    }

    /// Returns a figure, of a body that of one side.
    pub fn get(&self, figure: Figure, side: usize) -> f64 {
        self.values()[figure.at(side)]
    }

    /// Combines the values of two sets of figures one by one.
    #[must_use]
    pub fn zip(&self, other: &Self, combine: impl Fn(f64, f64) -> f64) -> Self {
        let (a, b) = (self.values(), other.values());
        Self::of(std::array::from_fn(|k| combine(a[k], b[k])))
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
pub struct FigureSet([bool; Figures::COUNT]);

impl FigureSet {
    /// All figures.
    pub const ALL: Self = Self([true; Figures::COUNT]);

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

    #[test]
    fn values_and_figures_are_each_others_inverse() {
        let values = std::array::from_fn(|k| k as f64);
        let figures = Figures::of(values);
        assert_eq!(figures.values().map(f64::to_bits), values.map(f64::to_bits));
        assert_eq!(figures.bodies[1].dent.to_bits(), values[Figure::Dent.at(1)].to_bits());
        assert_eq!(figures.force.to_bits(), values[Figure::Force.at(1)].to_bits());
        assert_eq!(Figure::ALL.len(), Figure::OF_CONTACT + Figure::OF_BODY);
        assert_eq!(Figure::LargestVonMises.name(), "largest_von_mises");
    }

    #[test]
    fn sets_tell_the_bodies_apart() {
        let set = FigureSet::of_bodies(&[Figure::Dent, Figure::Force], [false, true]);
        assert!(set.has(Figure::Dent, 1) && !set.has(Figure::Dent, 0));
        assert!(set.has(Figure::Force, 0) && !set.has(Figure::Approach, 0));
        assert_eq!(set.with(FigureSet::ALL), FigureSet::ALL);
    }
}
