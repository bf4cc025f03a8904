//! Operators of a track, beside those of a half-space without a ring.

use brinell_halfspace::raceway::RacewaySpace;
use brinell_halfspace::track::{Direction, Operators as _, TrackGrid};
use brinell_halfspace::{Elasticity, HalfSpace, Layers, TensorField};

use super::driver::{POISSON, YOUNG, space};

const COLUMNS: usize = 264;
const ROWS: usize = 8;
const WINDOW: usize = 17;

fn track(slides: bool) -> RacewaySpace {
    let grid = TrackGrid::ellipse(COLUMNS, ROWS, [0.1, 0.12], WINDOW).unwrap();
    space(grid, Layers::graded(0.08, 1.2, 1.0).unwrap(), slides)
}

/// Numbers between -½ and ½.
fn noise(n: usize, seed: u64) -> Vec<f64> {
    let mut state = seed;
    let mut next = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / (1_u64 << 31) as f64 - 0.5
    };
    (0..n).map(|_| next()).collect()
}

/// A field that is zero but in the window, and the same on the whole of a half-space.
fn strains(track: &RacewaySpace, seed: u64) -> (Vec<f64>, TensorField) {
    let (grid, n_layers) = (&track.ground().grid, track.ground().layers.len());
    let values = noise(n_layers * 5 * ROWS * WINDOW, seed);
    let mut field = vec![0.0; track.ground().field_len::<5>()];
    let mut whole = TensorField::deviators(n_layers, WINDOW * 2 * ROWS);
    let compliance = (1.0 + POISSON) / YOUNG;
    for (n, value) in values.into_iter().enumerate() {
        let (i, j, k, layer) =
            (n % WINDOW, n / WINDOW % ROWS, n / WINDOW / ROWS % 5, n / WINDOW / ROWS / 5);
        field[(layer * 5 + k) * grid.n_cells() + j * COLUMNS + grid.window().start + i] = value;
        // xy and yz are odd in y.
        let sign = if k == 2 || k == 4 { -1.0 } else { 1.0 };
        let component = whole.component_mut(layer, k);
        component[i * 2 * ROWS + ROWS + j] = compliance * value;
        component[i * 2 * ROWS + ROWS - 1 - j] = compliance * sign * value;
    }
    (field, whole)
}

fn pressures(seed: u64) -> (Vec<f64>, Vec<f64>) {
    let half: Vec<f64> = noise(ROWS * WINDOW, seed).iter().map(|p| p + 0.5).collect();
    let mut whole = vec![0.0; WINDOW * 2 * ROWS];
    for (n, p) in half.iter().enumerate() {
        let (i, j) = (n % WINDOW, n / WINDOW);
        whole[i * 2 * ROWS + ROWS + j] = *p;
        whole[i * 2 * ROWS + ROWS - 1 - j] = *p;
    }
    (half, whole)
}

fn half_space(track: &RacewaySpace) -> HalfSpace {
    let surface = track.ground().grid.surface().unwrap();
    let elastic = Elasticity::new(YOUNG, POISSON).unwrap();
    HalfSpace::new(surface, track.ground().layers.clone(), elastic, false, &mut || false).unwrap()
}

/// Largest difference of a field of the track and one of the half-space, and the largest value.
fn difference(track: &RacewaySpace, field: &[f64], whole: &TensorField) -> [f64; 2] {
    let mut most = [0.0_f64; 2];
    for (layer, k) in
        (0..track.ground().layers.len()).flat_map(|layer| (0..5).map(move |k| (layer, k)))
    {
        let component = whole.component(layer, k);
        for (i, j) in (0..WINDOW).flat_map(|i| (0..ROWS).map(move |j| (i, j))) {
            let cell = j * COLUMNS + track.ground().grid.window().start + i;
            let mine = field[(layer * 5 + k) * track.ground().grid.n_cells() + cell];
            let theirs = component[i * 2 * ROWS + ROWS + j];
            most = [most[0].max((mine - theirs).abs()), most[1].max(theirs.abs())];
        }
    }
    most
}

fn reach(track: &RacewaySpace) -> Vec<usize> {
    vec![ROWS; track.ground().layers.len()]
}

/// S and Sᵀ have no images: they are the sums that the half-space has.
#[test]
fn pressure_and_opening_are_those_of_a_half_space() {
    let track = track(false);
    let body = half_space(&track);
    let (half, whole) = pressures(3);
    let (mut stress, mut work) = (vec![0.0; track.ground().field_len::<5>()], track.work());
    let mut opening = vec![0.0; ROWS * WINDOW];
    track
        .opening(
            Direction::Normal,
            &stress,
            &vec![0; reach(&track).len()],
            &mut work,
            &mut opening,
            &mut || false,
        )
        .unwrap();
    track.stress(&half, 0.0, &mut work, &mut stress, &mut || false).unwrap();
    let mut expected = TensorField::deviators(track.ground().layers.len(), whole.len());
    let (mut nothing, mut their) = (vec![0.0; whole.len()], body.work());
    body.opening(&expected, &mut their, &mut nothing, &mut || false).unwrap();
    body.stress(&whole, &mut their, &mut expected, &mut || false).unwrap();
    let [apart, largest] = difference(&track, &stress, &expected);
    assert!(apart < 1e-12 * largest, "{apart} {largest}");

    let (field, strain) = strains(&track, 5);
    track
        .opening(Direction::Normal, &field, &reach(&track), &mut work, &mut opening, &mut || false)
        .unwrap();
    body.opening(&strain, &mut their, &mut nothing, &mut || false).unwrap();
    let largest = nothing.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
    for (n, u) in opening.iter().enumerate() {
        let expected = nothing[n % WINDOW * 2 * ROWS + ROWS + n / WINDOW];
        assert!((u - expected).abs() < 1e-12 * largest, "{u} {expected}");
    }
}

/// G has the images of the ring, thirty half-widths away, and none across: the half-space has those
/// of its own correction, 1e-3 of its largest stress.
#[test]
fn stress_of_plastic_strain_is_that_of_a_half_space() {
    let track = track(false);
    let body = half_space(&track);
    // A smooth zone: images of noise cancel.
    let (mut field, mut strain) = strains(&track, 1);
    let compliance = (1.0 + POISSON) / YOUNG;
    for (layer, k) in
        (0..track.ground().layers.len()).flat_map(|layer| (0..5).map(move |k| (layer, k)))
    {
        for (i, j) in (0..WINDOW).flat_map(|i| (0..ROWS).map(move |j| (i, j))) {
            let (x, y) = (i as f64 - 8.0, j as f64 + 0.5);
            let value = match k {
                0 => 0.4,
                1 => 0.5,
                2 => 0.02 * x * y,
                3 => 0.03 * x,
                _ => 0.03 * y,
            } * (1.0 - (x / 5.0).powi(2)).max(0.0)
                * (1.0 - (y / 5.0).powi(2)).max(0.0);
            let cell = j * COLUMNS + track.ground().grid.window().start + i;
            field[(layer * 5 + k) * track.ground().grid.n_cells() + cell] = value;
            let sign = if k == 2 || k == 4 { -1.0 } else { 1.0 };
            let component = strain.component_mut(layer, k);
            component[i * 2 * ROWS + ROWS + j] = compliance * value;
            component[i * 2 * ROWS + ROWS - 1 - j] = compliance * sign * value;
        }
    }
    let mut opening = vec![0.0; ROWS * WINDOW];
    let (mut work, mut stress) = (track.work(), vec![0.0; track.ground().field_len::<5>()]);
    track
        .opening(Direction::Normal, &field, &reach(&track), &mut work, &mut opening, &mut || false)
        .unwrap();
    track.stress(&vec![0.0; opening.len()], 0.0, &mut work, &mut stress, &mut || false).unwrap();
    let mut expected = TensorField::deviators(track.ground().layers.len(), WINDOW * 2 * ROWS);
    let (mut nothing, mut their) = (vec![0.0; WINDOW * 2 * ROWS], body.work());
    body.opening(&strain, &mut their, &mut nothing, &mut || false).unwrap();
    body.stress(
        &nothing.clone().iter().map(|_| 0.0).collect::<Vec<_>>(),
        &mut their,
        &mut expected,
        &mut || false,
    )
    .unwrap();
    let [apart, largest] = difference(&track, &stress, &expected);
    println!("{apart} of {largest}");
    assert!(apart < 6e-3 * largest, "{apart} {largest}");
}

#[test]
fn stress_of_plastic_strain_is_symmetric() {
    let track = track(false);
    let mut work = track.work();
    let mut opening = vec![0.0; ROWS * WINDOW];
    let (nothing, n_cells) = (opening.clone(), track.ground().grid.n_cells());
    let fields = [1, 2].map(|seed| noise(track.ground().field_len::<5>(), seed));
    let mut stress =
        [vec![0.0; track.ground().field_len::<5>()], vec![0.0; track.ground().field_len::<5>()]];
    for (field, stress) in fields.iter().zip(&mut stress) {
        track
            .opening(
                Direction::Normal,
                field,
                &reach(&track),
                &mut work,
                &mut opening,
                &mut || false,
            )
            .unwrap();
        track.stress(&nothing, 0.0, &mut work, stress, &mut || false).unwrap();
    }
    // a:b of deviators, with zz = -xx - yy.
    let product = |a: &[f64], b: &[f64]| -> f64 {
        let len = 5 * n_cells;
        let layers = a.chunks_exact(len).zip(b.chunks_exact(len)).enumerate();
        let of_layer = |(layer, (a, b)): (usize, (&[f64], &[f64]))| {
            let of_cell = |cell: usize| {
                let [a, b]: [[f64; 5]; 2] =
                    [a, b].map(|f| std::array::from_fn(|k| f[k * n_cells + cell]));
                a[0] * b[0]
                    + a[1] * b[1]
                    + (a[0] + a[1]) * (b[0] + b[1])
                    + 2.0 * (a[2] * b[2] + a[3] * b[3] + a[4] * b[4])
            };
            track.ground().layers.thickness(layer) * (0..n_cells).map(of_cell).sum::<f64>()
        };
        layers.map(of_layer).sum()
    };
    let [there, back] = [product(&fields[0], &stress[1]), product(&fields[1], &stress[0])];
    let size = -product(&fields[0], &stress[0]);
    assert!(size > 0.0, "negative definite: {size}");
    assert!((there - back).abs() < 1e-14 * size, "{there} {back} of {size}");
}

/// What does not depend on x is the same by all waves and by q_x = 0 alone.
#[test]
fn a_uniform_state_has_one_wave() {
    let track = track(false);
    let (grid, n_layers) = (&track.ground().grid, track.ground().layers.len());
    let values = noise(n_layers * ROWS * 5, 7);
    let rows: Vec<[f64; 5]> = values.chunks_exact(5).map(|v| v.try_into().unwrap()).collect();
    let mut field = Vec::new();
    for of_layer in rows.chunks_exact(ROWS) {
        for k in 0..5 {
            for row in of_layer {
                field.extend(std::iter::repeat_n(row[k], COLUMNS));
            }
        }
    }
    let (mut work, mut stress) = (track.work(), vec![0.0; track.ground().field_len::<5>()]);
    let mut opening = vec![0.0; ROWS * WINDOW];
    track
        .opening(Direction::Normal, &field, &reach(&track), &mut work, &mut opening, &mut || false)
        .unwrap();
    track.stress(&vec![0.0; opening.len()], 0.0, &mut work, &mut stress, &mut || false).unwrap();
    let uniform = track.uniform_stress(&rows, &mut work);
    for (row, [xx, yy, zz, xy, xz, yz]) in uniform.into_iter().enumerate() {
        let mean = (xx + yy + zz) / 3.0;
        let from = row / ROWS * 5 * grid.n_cells() + row % ROWS * COLUMNS + 13;
        for (k, value) in [xx - mean, yy - mean, xy, xz, yz].into_iter().enumerate() {
            let found = stress[from + k * grid.n_cells()];
            assert!((found - value).abs() < 1e-12, "{k}: {found} {value}");
        }
    }
}

/// Below a Hertzian traction that slides, `σxx = -q0 π(4+ν) x/8a` and σxz = -q at the surface
/// (G. M. Hamilton, 1983).
#[test]
fn a_traction_pulls_the_surface() {
    let (a, cells) = (1.0, 20);
    let h = a / f64::from(cells);
    let grid = TrackGrid::ellipse(160, 26, [h, h], 51).unwrap();
    let track = space(grid, Layers::new(vec![0.0, 1e-4 * h, 2e-4 * h]).unwrap(), true);
    let hertz: Vec<f64> = (0..26)
        .flat_map(|j| grid.window().map(move |i| (grid.x(i), grid.y(j))))
        .map(|(x, y)| (1.0 - (x * x + y * y) / (a * a)).max(0.0).sqrt())
        .collect();
    let deviators = |friction: f64| {
        let (mut work, mut stress) = (track.work(), vec![0.0; track.ground().field_len::<5>()]);
        let mut opening = vec![0.0; hertz.len()];
        track
            .opening(Direction::Normal, &stress, &[0, 0], &mut work, &mut opening, &mut || false)
            .unwrap();
        track.stress(&hertz, friction, &mut work, &mut stress, &mut || false).unwrap();
        stress
    };
    let (with, without) = (deviators(1.0), deviators(0.0));
    let column = grid.window().start + 25 + 10;
    let at = |k: usize| with[k * grid.n_cells() + column] - without[k * grid.n_cells() + column];
    // σzz is 0 at the surface: 2 s_xx + s_yy.
    let along = 2.0 * at(0) + at(1);
    let expected = -std::f64::consts::PI * (4.0 + POISSON) / 8.0 * grid.x(column) / a;
    assert!((along / expected - 1.0).abs() < 0.02, "{along} {expected}");
    let traction = hertz[35];
    assert!((at(3) / traction + 1.0).abs() < 1e-3, "{} {traction}", at(3));
}

/// By reciprocity the surface moves forward as a strain works on the stress of a traction, and by
/// what a line load along the track says of a uniform strain.
#[test]
fn a_uniform_strain_moves_the_surface_forward() {
    let track = track(true);
    let layers = track.ground().layers.len();
    // Shear xz of all rows: -2 ε h in the middle of a wide track.
    let mut strain = vec![[0.0; 5]; layers * ROWS];
    for row in &mut strain[..ROWS] {
        row[3] = -1e-3;
    }
    let forward = track.forward(&strain);
    let layer = track.ground().layers.thickness(0);
    assert!((forward / (2e-3 * layer) - 1.0).abs() < 0.05, "{forward} {layer}");
    // Compression in z sinks it.
    let mut polarization = vec![[0.0; 5]; layers * ROWS];
    for row in &mut polarization[ROWS..2 * ROWS] {
        (row[0], row[1]) = (100.0, 100.0);
    }
    let groove = track.settle(&polarization, &vec![[0.0; 2]; layers], &mut track.work()).groove;
    assert!(groove.iter().all(|u| *u > 0.0), "{groove:?}");
}
