//! Rows of each body: plastic strain and its zone, surfaces, stresses along a normal.

use super::{Answer, AnswerBody, Facts, Name};
use crate::job::Side;
use crate::report::known::{FlowFigures, SurfaceFigures, Zone};
use crate::solver::method::figures::Figure;

impl Facts<'_> {
    /// Returns the sides of which there are rows: of bodies that are alike one.
    pub fn sides(&self) -> &'static [Side] {
        if self.known.is_alike { &[Side::Lower] } else { &Side::BOTH }
    }

    /// Returns the row of a figure of a body with its bar.
    fn of_body(&self, name: Name, core: impl Into<Option<f64>>, figure: (Figure, Side)) -> Answer {
        let (figure, side) = figure;
        self.meshed(name, core, (figure, side.member())).of(self.body(side))
    }

    /// Returns the largest plastic strain of each body that can yield, where that has no limit the
    /// mean one, the larger of both before the details.
    pub(super) fn strains(&self) -> Vec<Answer> {
        let most = self.most_strained();
        let is_limited = self.zones().all(|(_, zone)| zone.largest.is_some());
        let zones = self.zones().filter(|(side, _)| self.sides().contains(side));
        let zones = zones.filter(|(side, _)| self.yield_point(*side).is_some());
        let rows = zones.flat_map(|(side, zone)| {
            let mean = Figure::MeanPlasticStrain;
            let mean = self.of_body(Name::MeanPlasticStrain, zone.mean, (mean, side));
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

    fn largest_strain(&self, side: Side, zone: &Zone) -> Answer {
        let figure = (Figure::MaxPlasticStrain, side);
        let row = self.of_body(Name::MaxPlasticStrain, zone.largest, figure);
        if zone.largest.is_none() {
            return row.not_known("it has no limit on finer meshes");
        }
        let place = self.place(self.body(side), zone.place);
        row.elastic(Some(0.0).filter(|_| self.touches()))
            .place(Some(place))
            .text(format!("of all {}", self.measured.points))
    }

    /// Returns how deep plastic strain reaches.
    pub fn plastic_depths(&self) -> Vec<Answer> {
        let depth = |side: &Side| {
            let depth = self.known.figures.bodies[side.member()]?.plastic_depth?;
            Some(self.row(Name::PlasticDepth, depth).of(self.body(*side)))
        };
        self.sides().iter().filter_map(depth).collect()
    }

    /// Returns depth and pile-up of each surface; without force of bodies that can be dented.
    pub(super) fn surfaces(&self, name: Name) -> Vec<Answer> {
        let Some(FlowFigures { surfaces, .. }) = &self.known.flow else { return Vec::new() };
        let of = |side: &Side| Some((*side, surfaces[side.member()]?));
        let is_shown = |side: &&Side| self.touches() || self.yield_point(**side).is_some();
        let both: Vec<_> = self.sides().iter().filter(is_shown).filter_map(of).collect();
        let depth = |(side, surface): &(Side, SurfaceFigures)| {
            self.of_body(name, surface.depth, (Figure::Dent, *side))
        };
        let pile_up = |(side, surface): &(Side, SurfaceFigures)| {
            let [x, y] = surface.pile_up_at;
            self.of_body(Name::PileUp, surface.pile_up, (Figure::PileUp, *side))
                .place(Some(self.place(self.body(*side), [x, y, 0.0])))
        };
        let reverse = |(side, surface): &(Side, SurfaceFigures)| {
            let [strain, area] = surface.reverse?;
            let rows = [(Name::ReversePlasticStrain, strain), (Name::ReversePlasticArea, area)];
            let body = self.body(*side);
            Some(rows.map(|(name, value)| self.row(name, value).of(body).detail()))
        };
        let reversed: Vec<_> = both.iter().filter_map(reverse).flatten().collect();
        both.iter().map(depth).chain(both.iter().map(pile_up)).chain(reversed).collect()
    }

    /// Returns the plastic zone of each body and the stresses along the normal below the middle.
    pub(super) fn of_bodies(&self) -> Vec<Answer> {
        let mut rows = Vec::new();
        for (side, zone) in self.zones().filter(|(side, _)| self.sides().contains(side)) {
            let body = self.body(side);
            if zone.yielded {
                let area = (Figure::PlasticArea, side);
                rows.push(self.of_body(Name::PlasticArea, zone.area, area));
                rows.extend(zone.cover.map(|top| self.row(Name::PlasticCover, top).of(body)));
            }
            let volume = zone.volume.filter(|volume| *volume > 0.0);
            rows.extend(volume.map(|volume| self.row(Name::PlasticVolume, volume).of(body)));
            let Some(figures) = self.known.figures.bodies[side.member()] else { continue };
            let stresses = [
                (Name::LeastStress, figures.least_stress, Figure::LeastStress),
                (Name::LargestVonMises, figures.largest_von_mises, Figure::LargestVonMises),
            ];
            rows.extend(stresses.into_iter().filter_map(|(name, stress, figure)| {
                let stress = stress.filter(|stress| self.touches() || *stress != 0.0)?;
                Some(self.of_body(name, stress, (figure, side)))
            }));
        }
        rows.into_iter().map(Answer::detail).collect()
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
