//! The search over one number: where a figure crosses its value, and where it is least.

/// Looks between the two ends of a bracket, at most. A figure that jumps needs all of them.
const MOST: usize = 10;
/// Looks at a least figure behind those at the five first places.
const MOST_AT_LEAST: usize = 4;
/// Parts of the range at which an optimum is looked for.
const INNER: [f64; 3] = [0.5, 0.25, 0.75];

/// One look at the figure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// The coordinate of the search.
    pub at: f64,
    /// How far the figure is above what is wanted.
    pub off: f64,
    /// Up to where that is near enough.
    pub good: f64,
}

impl Point {
    /// Returns whether the figure is as wanted.
    pub fn is_good(self) -> bool {
        self.off.abs() <= self.good
    }

    fn is_beside(self, other: Self) -> bool {
        self.off * other.off < 0.0
    }
}

/// Returns the crossings that the ends and, where those lie on one side, three places between them
/// show, in the order of the coordinate; `None` where they show none.
///
/// # Errors
/// Those of a look.
pub fn crossings<E>(
    [low, high]: [f64; 2],
    look: &mut dyn FnMut(f64) -> Result<Point, E>,
) -> Result<Option<Vec<Point>>, E> {
    let mut points = vec![look(low)?, look(high)?];
    let is_open = |points: &[Point]| {
        points.iter().all(|point| !point.is_good() && !point.is_beside(points[0]))
    };
    for part in INNER {
        if is_open(&points) {
            points.push(look(low + part * (high - low))?);
        }
    }
    if is_open(&points) {
        return Ok(None);
    }
    points.sort_by(|one, other| one.at.total_cmp(&other.at));
    let mut found: Vec<Point> = points.iter().copied().filter(|point| point.is_good()).collect();
    for pair in points.windows(2) {
        if let [one, other] = *pair
            && one.is_beside(other)
            && !one.is_good()
            && !other.is_good()
        {
            found.push(crossing([one, other], look)?);
        }
    }
    found.sort_by(|one, other| one.at.total_cmp(&other.at));
    Ok(Some(found))
}

/// Closes a bracket by Chandrupatla's method: a secant first, then inverse parabolas where three
/// looks tell one, else halves.
fn crossing<E>(
    [mut here, mut across]: [Point; 2],
    look: &mut dyn FnMut(f64) -> Result<Point, E>,
) -> Result<Point, E> {
    let mut best = if here.off.abs() < across.off.abs() { here } else { across };
    let mut part = here.off / (here.off - across.off);
    for _ in 0..MOST {
        let point = look(here.at + part * (across.at - here.at))?;
        if point.is_good() {
            return Ok(point);
        }
        if point.off.abs() <= best.off.abs() {
            best = point;
        }
        let before = if point.is_beside(here) { across } else { here };
        if point.is_beside(here) {
            across = here;
        }
        here = point;
        part = inverse_parabola(here, across, before).unwrap_or(0.5);
    }
    Ok(best)
}

/// Returns the part of the way from one side to the other at which the parabola through three looks
/// crosses zero, where it rises or falls all the way.
fn inverse_parabola(here: Point, across: Point, before: Point) -> Option<f64> {
    let way = (here.at - across.at) / (before.at - across.at);
    let rise = (here.off - across.off) / (before.off - across.off);
    let is_one_to_one = rise.powi(2) < way && (1.0 - rise).powi(2) < 1.0 - way;
    is_one_to_one.then(|| {
        let [here_off, across_off, before_off] = [here.off, across.off, before.off];
        let of_across =
            here_off / (across_off - here_off) * before_off / (across_off - before_off);
        let of_before =
            here_off / (before_off - here_off) * across_off / (before_off - across_off);
        of_across + (before.at - here.at) / (across.at - here.at) * of_before
    })
}

/// Where a figure is least, and half the second derivative of `off` there; 0 at an end. Looks at
/// the vertex of a parabola, which a kink misleads, and halves of the wider side take turns.
///
/// # Errors
/// Those of a look.
pub fn least<E>(
    [low, high]: [f64; 2],
    look: &mut dyn FnMut(f64) -> Result<Point, E>,
) -> Result<(Point, f64), E> {
    let mut points = Vec::new();
    for part in [0.0, 1.0].into_iter().chain(INNER) {
        points.push(look(low + part * (high - low))?);
    }
    for number in 0..=MOST_AT_LEAST {
        points.sort_by(|one, other| one.at.total_cmp(&other.at));
        let lowest = points.iter().enumerate().min_by(|a, b| a.1.off.total_cmp(&b.1.off));
        let Some((place, &middle)) = lowest else { break };
        let &[before, _, after] = points.get(place.wrapping_sub(1)..=place + 1).unwrap_or(&[])
        else {
            return Ok((middle, 0.0));
        };
        let slope = |one: Point, other: Point| (other.off - one.off) / (other.at - one.at);
        let (left, right) = (slope(before, middle), slope(middle, after));
        let bend = (right - left) / (after.at - before.at);
        let vertex = f64::midpoint(before.at, middle.at) - left / (2.0 * bend);
        let gain = bend * (vertex - middle.at).powi(2);
        let is_at_vertex = gain.is_nan() || gain <= middle.good;
        if number == MOST_AT_LEAST || number > 1 && is_at_vertex {
            return Ok((middle, bend));
        }
        let is_half = is_at_vertex || number % 2 == 1;
        let side = if after.at - middle.at > middle.at - before.at { after } else { before };
        let half = f64::midpoint(middle.at, side.at);
        points.push(look(if is_half { half } else { vertex })?);
    }
    Ok((points[0], 0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Searches a function for zero; returns the places and the number of looks.
    fn zeros(ends: [f64; 2], of: impl Fn(f64) -> f64) -> (Option<Vec<f64>>, usize) {
        let mut looks = 0;
        let found = crossings(ends, &mut |at| {
            looks += 1;
            Ok::<_, ()>(Point { at, off: of(at), good: 1e-4 })
        });
        let places = |points: Vec<Point>| points.iter().map(|point| point.at).collect();
        (found.unwrap().map(places), looks)
    }

    #[test]
    fn a_power_takes_one_secant() {
        let (found, looks) = zeros([0.0, 3.0], |at| 0.7 * at - 1.0);
        assert!((found.unwrap()[0] - 1.0 / 0.7).abs() < 1e-3);
        assert_eq!(looks, 3);
    }

    #[test]
    fn bends_and_jumps_end() {
        let (found, looks) = zeros([0.0, 3.0], |at| at.exp() - 5.0);
        assert!((found.unwrap()[0] - 5.0_f64.ln()).abs() < 1e-4);
        assert!(looks <= 8, "{looks}");
        let (found, looks) = zeros([0.0, 3.0], |at| if at < 1.3 { -3.0 } else { 0.2 });
        assert!((found.unwrap()[0] - 1.3).abs() < 0.05);
        assert!(looks <= 2 + MOST, "{looks}");
    }

    #[test]
    fn an_optimum_has_two_crossings_or_none() {
        let (found, _) = zeros([-1.0, 2.0], |at| at * at - 0.2);
        let found = found.unwrap();
        assert_eq!(found.len(), 2);
        assert!(
            (found[0] + 0.2_f64.sqrt()).abs() < 1e-3 && (found[1] - 0.2_f64.sqrt()).abs() < 1e-3
        );
        assert_eq!(zeros([-1.0, 2.0], |at| at * at + 0.1), (None, 5));
    }

    #[test]
    fn the_least_figure_is_found_inside_and_at_an_end() {
        let mut look = |at: f64| Ok::<_, ()>(Point { at, off: (at - 0.3).powi(2), good: 1e-9 });
        let (found, bend) = least([-1.0, 2.0], &mut look).unwrap();
        assert!((found.at - 0.3).abs() < 1e-9 && (bend - 1.0).abs() < 1e-9);
        let mut kink = |at: f64| {
            let off = if at < 0.3 { 1.3 - at } else { 3.0 * at + 0.1 };
            Ok::<_, ()>(Point { at, off, good: 1e-3 })
        };
        let (found, _) = least([-1.0, 2.0], &mut kink).unwrap();
        assert!((found.at - 0.3).abs() < 0.2, "{found:?}");
        let (found, bend) = least([1.0, 2.0], &mut look).unwrap();
        assert_eq!((found.at, bend), (1.0, 0.0));
    }
}
