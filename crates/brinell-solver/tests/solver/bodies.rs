//! Single bodies under nodal forces: the core without contact, put together by hand.

use std::sync::Arc;

use brinell_solver::fem::assembly::{
    Equations, Extent, MaterialModel, PlasticPoints, PointStresses, Restraint, StiffnessAssembler,
    StressField, Unloaded, given_stress, initial_force, out_of_plane, relaxed_stress,
};
use brinell_solver::fem::element::{QUADRATURE_POINTS, StressState, element_stiffness};
use brinell_solver::fem::mesh::{ContactZone, Mesh, SurfaceFrame};
use brinell_solver::job::{Deformable, Elastic, Hardening, PoissonRatio, PositiveF64};
use brinell_solver::material::{DeformationPlasticity, ElasticModuli};
use sparse_cholesky::{Cholesky, EliminationOrder, Graph, LatticePoint, SymbolicCholesky};

pub fn positive(value: f64) -> PositiveF64 {
    PositiveF64::new(value).unwrap()
}

pub fn material(young: f64, poisson: f64, plasticity: Option<Hardening>) -> Deformable {
    let elastic = Elastic {
        young_modulus: positive(young),
        poisson_ratio: PoissonRatio::new(poisson).unwrap(),
    };
    Deformable::new(elastic, plasticity)
}

/// A mesh of `columns × rows` quadrilaterals with nodes at `place(i, j)`.
pub fn grid(columns: i32, rows: i32, place: impl Fn(i32, i32) -> [f64; 2]) -> Mesh {
    let node = |i: i32, j: i32| u32::try_from(i * (rows + 1) + j).unwrap();
    let points = || (0..=columns).flat_map(|i| (0..=rows).map(move |j| (i, j)));
    let cells = (0..columns).flat_map(|i| (0..rows).map(move |j| (i, j)));
    let elements: Vec<[u32; 4]> = cells
        .map(|(i, j)| [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)])
        .collect();
    Mesh {
        nodes: points().map(|(i, j)| place(i, j)).collect(),
        elements,
        contact_nodes: Vec::new(),
        free_surface_nodes: (0..=columns).map(|i| node(i, 0)).collect(),
        support_nodes: Vec::new(),
        axis_nodes: Vec::new(),
        lattice: points().map(|(i, j)| LatticePoint { patch: 0, i, j }).collect(),
        zone: ContactZone::uniform(0.0, 1.0, 1, false),
        contact_normals: Vec::new(),
        frame: SurfaceFrame::Tangent,
    }
}

/// State of a body after the initial-stress iteration.
pub struct Loaded {
    pub displacement: Vec<[f64; 2]>,
    pub field: StressField,
    pub iterations: usize,
}

/// A body that is held, and takes nodal forces one after the other.
pub struct Specimen {
    mesh: Mesh,
    equations: Equations,
    factor: Cholesky,
    model: Arc<dyn MaterialModel>,
    stress_state: StressState,
    region: Option<Box<dyn PlasticPoints>>,
    /// Displacements by equation under the last forces.
    u: Vec<f64>,
}

impl Specimen {
    pub fn new(
        mesh: &Mesh,
        stress_state: StressState,
        model: Arc<dyn MaterialModel>,
        held: Vec<[bool; 2]>,
    ) -> Self {
        let graph = Graph::from_cells(mesh.nodes.len(), &mesh.elements);
        let order = EliminationOrder::new(&graph, &mesh.lattice, &[]);
        let equations = Equations::new(&order, &Restraint::from(held), 0);
        let symbolic = SymbolicCholesky::new(equations.pattern(&graph)).unwrap();
        let assembler = StiffnessAssembler {
            mesh,
            stress_state,
            equations: &equations,
            pattern: symbolic.pattern(),
        };
        let ElasticModuli { bulk, shear } = model.elastic();
        let values = assembler
            .assemble(|_, quad| element_stiffness(quad, bulk, &[shear; QUADRATURE_POINTS]));
        let factor = Cholesky::factor(&symbolic, &values).unwrap();
        let unloaded = Unloaded { mesh, stress_state, initial_stress: None };
        let everywhere = vec![true; mesh.elements.len()];
        let region = model
            .hardening()
            .map(|_| Arc::clone(&model).points(&unloaded, &equations, &everywhere));
        let u = vec![0.0; equations.len() + 1];
        Self { mesh: mesh.clone(), equations, factor, model, stress_state, region, u }
    }

    /// Solves `∫Bᵀσ dV = force` from the accepted states by the plain initial-stress iteration,
    /// until displacements change by less than 1e-11.
    pub fn load(&mut self, force: &[[f64; 2]], max_iterations: usize) -> Loaded {
        let equations = &self.equations;
        let mut external = vec![0.0; equations.len() + 1];
        for (node, f) in (0u32..).zip(force) {
            for (&k, f) in equations.of_node(node).iter().zip(f) {
                external[k as usize] += f;
            }
        }
        external[equations.len()] = 0.0;
        let mut u = external.clone();
        self.factor.solve(&mut u);
        let mut iterations = 1;
        let mut plastic = vec![0.0; u.len()];
        while let Some(region) = self.region.as_ref().filter(|_| iterations < max_iterations) {
            region.evaluate(&u, &mut plastic);
            let mut next: Vec<f64> = external.iter().zip(&plastic).map(|(r, p)| r + p).collect();
            self.factor.solve(&mut next);
            let change: f64 = next.iter().zip(&u).map(|(a, b)| (a - b).powi(2)).sum();
            let size: f64 = next.iter().map(|v| v * v).sum();
            u = next;
            iterations += 1;
            if change <= 1e-22 * size {
                break;
            }
        }
        let nodes = (0u32..).take(self.mesh.nodes.len());
        let displacement: Vec<[f64; 2]> =
            nodes.map(|node| equations.of_node(node).map(|k| u[k as usize])).collect();
        self.u = u;
        let unloaded =
            Unloaded { mesh: &self.mesh, stress_state: self.stress_state, initial_stress: None };
        let field = match &self.region {
            Some(region) => region.stress_field(&unloaded, &displacement, Extent::Body),
            None => self.model.stress_field(&unloaded, &displacement),
        };
        Loaded { displacement, field, iterations }
    }

    /// What is left of a stress that is given before any load.
    pub fn relaxed(&self, given: impl Fn([f64; 2]) -> [f64; 4]) -> PointStresses {
        let Self { mesh, equations, stress_state, .. } = self;
        let given = given_stress(mesh, *stress_state, given);
        let force = initial_force(mesh, *stress_state, equations, &given);
        let mut u: Vec<f64> = force.iter().map(|f| -f).collect();
        self.factor.solve(&mut u);
        let nodes = (0u32..).take(mesh.nodes.len());
        let nodal: Vec<_> =
            nodes.map(|node| equations.of_node(node).map(|k| u[k as usize])).collect();
        relaxed_stress(mesh, *stress_state, self.model.elastic(), &given, &nodal)
    }

    /// Accepts the states under the last forces.
    pub fn commit(&mut self) {
        if let Some(region) = &mut self.region {
            region.commit(&self.u);
        }
    }
}

/// A body at rest under forces, by deformation theory.
pub fn load(
    mesh: &Mesh,
    stress_state: StressState,
    material: &Deformable,
    held: Vec<[bool; 2]>,
    force: &[[f64; 2]],
    max_iterations: usize,
) -> Loaded {
    let model = Arc::new(DeformationPlasticity::with_law(
        ElasticModuli::from(&material.elastic),
        material.hardening_law(),
        out_of_plane(stress_state),
    ));
    Specimen::new(mesh, stress_state, model, held).load(force, max_iterations)
}
