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

/// A tensor or a deviator in every cell of every layer: layer outermost, then component, then cell
/// of the surface grid.
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
        Self {
            n_layers,
            n_cells,
            n_components,
            values: vec![0.0; n_layers * n_components * n_cells],
        }
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

/// Coordinates of a deviator `xx yy xy xz yz` in which `a:b` is the sum of products.
#[inline(always)]
pub fn isometric([xx, yy, xy, xz, yz]: [f64; DEVIATOR_COMPONENTS]) -> [f64; DEVIATOR_COMPONENTS] {
    let two = std::f64::consts::SQRT_2;
    [(xx - yy) / two, 1.5_f64.sqrt() * (xx + yy), two * xy, two * xz, two * yz]
}

/// The reverse of [`isometric`].
#[inline(always)]
pub fn from_isometric(
    [d, s, xy, xz, yz]: [f64; DEVIATOR_COMPONENTS],
) -> [f64; DEVIATOR_COMPONENTS] {
    let two = std::f64::consts::SQRT_2;
    let (difference, sum) = (two * d, s / 1.5_f64.sqrt());
    [0.5 * (sum + difference), 0.5 * (sum - difference), xy / two, xz / two, yz / two]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn isometric_coordinates_keep_the_double_contraction() {
        let e = [0.3, -0.5, 0.2, 0.7, -0.1];
        let zz = -e[0] - e[1];
        let square =
            e[0] * e[0] + e[1] * e[1] + zz * zz + 2.0 * (e[2] * e[2] + e[3] * e[3] + e[4] * e[4]);
        let scaled = isometric(e);
        assert!((scaled.iter().map(|x| x * x).sum::<f64>() - square).abs() < 1e-15);
        for (back, value) in from_isometric(scaled).into_iter().zip(e) {
            assert!((back - value).abs() < 1e-15);
        }
    }
}
