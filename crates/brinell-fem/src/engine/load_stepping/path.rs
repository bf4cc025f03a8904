//! Path of a history on one mesh, by which the next mesh goes.

use std::sync::Arc;

use crate::mesh::Mesh;

/// The displacements of a history on one mesh, linear between the ends of its increments.
#[derive(Default)]
pub(super) struct Path {
    pub meshes: Vec<Arc<Mesh>>,
    /// Number of the load plus the part of it that is done, and the displacements of all nodes of
    /// each model.
    pub points: Vec<(f64, Vec<Vec<[f64; 2]>>)>,
}

impl Path {
    /// Bytes of the displacements.
    pub fn bytes(&self) -> usize {
        let nodes: usize = self.meshes.iter().map(|mesh| mesh.nodes.len()).sum();
        self.points.len() * nodes * size_of::<[f64; 2]>()
    }

    /// Returns the changes of the displacements from one time to the ends of the increments within
    /// a later time, if they are to be `followed`, and to this one.
    pub fn changes(&self, from: f64, to: f64, followed: bool) -> Vec<Vec<Vec<[f64; 2]>>> {
        let start = self.at(from);
        let ends = self.points.iter().map(|(time, _)| *time);
        let within = ends.filter(|time| followed && from < *time && *time < to);
        let change = |time| {
            let mut change = self.at(time);
            for (to, from) in change.iter_mut().flatten().zip(start.iter().flatten()) {
                *to = [to[0] - from[0], to[1] - from[1]];
            }
            change
        };
        within.chain([to]).map(change).collect()
    }

    fn at(&self, time: f64) -> Vec<Vec<[f64; 2]>> {
        let after = self.points.partition_point(|(t, _)| *t < time);
        let rest = || self.meshes.iter().map(|mesh| vec![[0.0; 2]; mesh.nodes.len()]).collect();
        let Some((t1, end)) = self.points.get(after) else {
            return self.points.last().map_or_else(rest, |(_, last)| last.clone());
        };
        let before = after.checked_sub(1).map(|k| &self.points[k]);
        let t0 = before.map_or(0.0, |(t, _)| *t);
        let part = (time - t0) / (t1 - t0);
        let mut now = end.clone();
        let start = before.map(|(_, start)| start);
        for (k, nodes) in now.iter_mut().enumerate() {
            for (n, value) in nodes.iter_mut().enumerate() {
                let from = start.map_or([0.0; 2], |start| start[k][n]);
                *value =
                    [from[0] + part * (value[0] - from[0]), from[1] + part * (value[1] - from[1])];
            }
        }
        now
    }
}
