//! Rows of each body: plastic strain and its zone, surfaces, stresses along a normal.

use super::{Answer, AnswerBody, AnswerPlace, Facts, Name};
use crate::job::{Quantity, Side};
use crate::report::{BodyErrors, FlowReport, PerBody, PlasticityReport, SurfaceReport};
use crate::solver::method::figures::Figure;
use crate::units::about;

type BarOf = fn(&BodyErrors) -> Option<f64>;

impl Facts<'_> {
    /// Returns the sides of which there are rows: of bodies that are alike one.
    fn sides(&self) -> &'static [Side] {
        if self.is_alike() { &[Side::Lower] } else { &Side::BOTH }
    }

    fn body_bar(&self, side: Side, bar: BarOf) -> Option<f64> {
        let whole = self.step.three_dimensional.as_ref();
        let of_ellipse = whole.and_then(|whole| whole.estimated_error.as_ref());
        let bars = self.bars()?;
        let PerBody { upper, lower } = of_ellipse.map(|errors| errors.bodies).or(bars.bodies)?;
        let errors = if side == Side::Upper { upper } else { lower };
        errors.as_ref().and_then(bar)
    }

    /// Returns the row of a figure of a body with its bar.
    fn of_body(
        &self,
        (name, side): (Name, Side),
        value: impl Into<Option<f64>>,
        figure: Figure,
        bar: BarOf,
    ) -> Answer {
        let bar = self.body_bar(side, bar);
        self.meshed(name, value, (figure, side.member()), bar).of(self.body(side))
    }

    /// Returns the largest plastic strain of each body, where that has no limit the mean one, the
    /// larger of both before the details.
    pub(super) fn strains(&self) -> Vec<Answer> {
        let most = self.most_strained().map(|(body, _)| body);
        let is_limited =
            self.zones().all(|(_, zone)| zone.max_equivalent_plastic_strain.is_some());
        let zones = self.zones().filter(|(side, _)| self.sides().contains(side));
        let rows = zones.flat_map(|(side, zone)| {
            let mean = self.mean_strain(side, zone);
            let largest = self.largest_strain(side, zone);
            let is_most = most == Some(self.body(side));
            match (is_most, is_limited) {
                (true, true) => [largest, mean.detail()],
                (true, false) => [mean, largest.detail()],
                (false, _) => [largest.detail(), mean.detail()],
            }
        });
        rows.collect()
    }

    fn largest_strain(&self, side: Side, zone: &PlasticityReport) -> Answer {
        let (name, value) = (Name::MaxPlasticStrain, zone.max_equivalent_plastic_strain);
        let row = self.of_body((name, side), value, Figure::MaxPlasticStrain, |errors| {
            errors.max_equivalent_plastic_strain
        });
        if value.is_none() {
            return row.not_known("it has no limit on finer meshes");
        }
        let place = AnswerPlace {
            body: self.body(side),
            x: zone.position,
            y: zone.position_y,
            depth: zone.depth,
        };
        row.elastic(Some(0.0).filter(|_| self.touches()))
            .place(Some(place).filter(|_| value > Some(0.0)))
            .text(format!("of all {}", self.measured.points))
    }

    fn mean_strain(&self, side: Side, zone: &PlasticityReport) -> Answer {
        let value = zone.mean_equivalent_plastic_strain;
        self.of_body((Name::MeanPlasticStrain, side), value, Figure::MeanPlasticStrain, |errors| {
            errors.mean_equivalent_plastic_strain
        })
        .text("over the area that has yielded")
    }

    /// Returns how deep plastic strain reaches.
    pub fn plastic_depths(&self) -> Vec<Answer> {
        let figures = &self.measured.figures;
        let depth = |side: &Side| {
            let depth = figures.get(Figure::PlasticDepth, side.member())?;
            let row = self.row(Name::PlasticDepth, self.write.length(depth));
            Some(row.of(self.body(*side)))
        };
        self.sides().iter().filter_map(depth).collect()
    }

    /// Returns depth and pile-up of each surface. Under load the surfaces of half-spaces have an
    /// elastic deflection, which has no bar.
    pub(super) fn surfaces(&self, name: Name) -> Vec<Answer> {
        let Some(FlowReport { surfaces, .. }) = &self.step.flow else { return Vec::new() };
        let has_bar = self.is_unloaded() || !self.is_three_dimensional();
        let bar_of = |bar: BarOf| if has_bar { bar } else { |_: &BodyErrors| None };
        let of = |side: Side| {
            let surface = if side == Side::Upper { &surfaces.upper } else { &surfaces.lower };
            surface.as_ref().map(|surface| (side, surface))
        };
        let both: Vec<_> = self.sides().iter().filter_map(|side| of(*side)).collect();
        let depth = |(side, surface): &(Side, &SurfaceReport)| {
            let reversed = if surface.yielded_in_reverse { "; yielded in reverse" } else { "" };
            let bar = bar_of(|errors| errors.depth);
            self.of_body((name, *side), surface.depth, Figure::Dent, bar)
                .text(format!("deepest point below the undeformed surface{reversed}"))
        };
        let pile_up = |(side, surface): &(Side, &SurfaceReport)| {
            let bar = bar_of(|errors| errors.pile_up);
            let row = self.of_body((Name::PileUp, *side), surface.pile_up, Figure::PileUp, bar);
            if surface.pile_up <= 0.0 {
                return row;
            }
            let from = surface.pile_up_position;
            let place = AnswerPlace { body: self.body(*side), x: from, y: None, depth: 0.0 };
            row.place(Some(place)).text(format!(
                "highest point above the undeformed surface, {} from the middle",
                self.with_unit(about, Quantity::Length, from)
            ))
        };
        let reverse = |(side, surface): &(Side, &SurfaceReport)| {
            let rows = [
                (Name::ReversePlasticStrain, surface.max_reverse_strain),
                (Name::ReversePlasticArea, surface.reverse_area),
            ];
            let rows = rows.map(|(name, value)| self.row(name, value).of(self.body(*side)));
            surface.yielded_in_reverse.then(|| rows.map(Answer::detail))
        };
        let reversed = both.iter().filter_map(reverse).flatten().collect::<Vec<_>>();
        both.iter().map(depth).chain(both.iter().map(pile_up)).chain(reversed).collect()
    }

    /// Returns the plastic zone of each body and the stresses along the normal below the middle.
    pub(super) fn of_bodies(&self) -> Vec<Answer> {
        let mut rows = Vec::new();
        for (side, zone) in self.zones().filter(|(side, _)| self.sides().contains(side)) {
            let body = self.body(side);
            if zone.yielded {
                let area = Name::PlasticArea;
                rows.push(
                    self.of_body((area, side), zone.area, Figure::PlasticArea, |errors| {
                        errors.area
                    }),
                );
                rows.extend(self.cover(side, zone).map(|row| row.of(body)));
            }
            let volume = zone.volume.filter(|volume| *volume > 0.0);
            rows.extend(volume.map(|volume| self.row(Name::PlasticVolume, volume).of(body)));
            let stress = |figure: Figure| self.measured.figures.get(figure, side.member());
            let least = stress(Figure::LeastStress).map(|stress| self.write.stress(stress));
            rows.extend(least.map(|stress| {
                self.of_body((Name::LeastStress, side), stress, Figure::LeastStress, |errors| {
                    errors.least_stress
                })
            }));
            let most = stress(Figure::LargestVonMises).map(|stress| self.write.stress(stress));
            rows.extend(most.map(|stress| {
                let name = Name::LargestVonMises;
                self.of_body((name, side), stress, Figure::LargestVonMises, |errors| {
                    errors.utilization
                })
            }));
        }
        rows.into_iter().map(Answer::detail).collect()
    }

    /// Returns the depth at which a plastic zone begins.
    fn cover(&self, side: Side, zone: &PlasticityReport) -> Option<Answer> {
        let depths = zone.outline.iter().flatten().map(|point| point[1]);
        let drawn = depths.reduce(f64::min);
        let of_cells = || {
            let top = self.measured.plastic_tops[side.member()]?;
            Some(self.write.length(top))
        };
        let top = if zone.reached_surface { Some(0.0) } else { drawn.or_else(of_cells) };
        Some(self.row(Name::PlasticCover, top?.max(0.0)))
    }
}

impl AnswerBody {
    /// Returns the body in a sentence.
    pub(in crate::report) const fn in_words(self) -> &'static str {
        match self {
            Self::Upper => " in the upper body",
            Self::Lower => " in the lower body",
            Self::Both => "",
        }
    }
}
