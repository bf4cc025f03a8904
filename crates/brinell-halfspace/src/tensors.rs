//! Fields of symmetric tensors in the cells of the layers.

/// Order of the components of a tensor: xx yy zz xy xz yz, tensor shear.
pub const COMPONENTS: usize = 6;
/// Order of the components of a deviator: xx yy xy xz yz; `zz = -xx - yy`.
pub const DEVIATOR_COMPONENTS: usize = 5;

/// Rows of a deviator among those of a tensor.
pub(crate) const DEVIATOR_ROWS: [usize; DEVIATOR_COMPONENTS] = [0, 1, 3, 4, 5];
pub(crate) const TENSOR_ROWS: [usize; COMPONENTS] = [0, 1, 2, 3, 4, 5];
/// Weights of the double contraction.
pub(crate) const WEIGHTS: [f64; COMPONENTS] = [1.0, 1.0, 1.0, 2.0, 2.0, 2.0];

/// A tensor or a deviator in every cell of every layer: layer outermost, then component, then cell of the surface grid.
#[derive(Debug, Clone, PartialEq)]
pub struct TensorField {
    n_layers: usize,
    n_cells: usize,
    n_components: usize,
    values: Vec<f64>,
}

impl TensorField {
    /// Zero tensors.
    pub fn tensors(n_layers: usize, n_cells: usize) -> Self {
        Self::zeros(n_layers, n_cells, COMPONENTS)
    }

    /// Zero deviators.
    pub fn deviators(n_layers: usize, n_cells: usize) -> Self {
        Self::zeros(n_layers, n_cells, DEVIATOR_COMPONENTS)
    }

    fn zeros(n_layers: usize, n_cells: usize, n_components: usize) -> Self {
        Self { n_layers, n_cells, n_components, values: vec![0.0; n_layers * n_components * n_cells] }
    }

    /// Layers.
    pub const fn n_layers(&self) -> usize {
        self.n_layers
    }

    /// Cells of a layer.
    pub const fn n_cells(&self) -> usize {
        self.n_cells
    }

    /// 6 for tensors, 5 for deviators.
    pub const fn n_components(&self) -> usize {
        self.n_components
    }

    /// One component in one layer.
    pub fn component(&self, layer: usize, component: usize) -> &[f64] {
        &self.values[(layer * self.n_components + component) * self.n_cells..][..self.n_cells]
    }

    /// One component in one layer.
    pub fn component_mut(&mut self, layer: usize, component: usize) -> &mut [f64] {
        &mut self.values[(layer * self.n_components + component) * self.n_cells..][..self.n_cells]
    }

    /// All components of one layer.
    pub fn layer(&self, layer: usize) -> &[f64] {
        let len = self.n_components * self.n_cells;
        &self.values[layer * len..][..len]
    }

    /// All components of one layer.
    pub fn layer_mut(&mut self, layer: usize) -> &mut [f64] {
        let len = self.n_components * self.n_cells;
        &mut self.values[layer * len..][..len]
    }

    /// All numbers.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// All numbers.
    pub fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }

    /// The rows of a tensor that the components are.
    pub(crate) const fn rows(&self) -> &'static [usize] {
        if self.n_components == COMPONENTS { &TENSOR_ROWS } else { &DEVIATOR_ROWS }
    }
}
