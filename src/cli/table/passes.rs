//! The passes of a load that rolls as a table, its middle left out when it is long.

use super::number::significant;
use super::text::folded;
use crate::cli::style::Style;
use brinell_solver::job::Named as _;
use brinell_solver::report::{Name, PassesReport};

/// The passes, with the figures of the body that yields more.
pub(super) fn passes(passes: &PassesReport, length: &str, stress: &str, style: Style) -> String {
    let head = style.dim(&format!(
        "{:>4} {:>5} {:>10} {:>10} {:>11} {:>11} {:>9} {:>10}\n",
        "pass",
        "iter",
        "strain %",
        "net %",
        format!("forward {length}"),
        format!("track {length}"),
        format!("peak {stress}"),
        "resistance"
    ));
    head + &folded(passes.number.len(), style, |index| row(passes, index))
}

fn row(passes: &PassesReport, index: usize) -> String {
    let of_contact = |name: Name| passes.contact.get(name.name())?.value.get(index).copied();
    let strain = Name::PassStrain.name();
    let most = |side: usize| {
        let columns = [&passes.lower, &passes.upper][side];
        Some((columns.get(strain)?.value.get(index).copied()?, columns))
    };
    let strained = [most(0), most(1)].into_iter().flatten();
    let strained = strained.reduce(|a, b| if b.0 > a.0 { b } else { a });
    let of_body = |name: Name| strained?.1.get(name.name())?.value.get(index).copied();
    let shown = |value: Option<f64>, factor: f64, digits: i32| {
        value.map_or_else(|| "—".to_owned(), |value| significant(factor * value, digits))
    };
    format!(
        "{:>4} {:>5} {:>10} {:>10} {:>11} {:>11} {:>9} {:>10}\n",
        passes.number[index],
        passes.iterations.get(index).copied().unwrap_or_default(),
        shown(of_body(Name::PassStrain), 100.0, 4),
        shown(of_body(Name::NetStrain), 100.0, 4),
        shown(of_body(Name::ForwardDisplacement), 1.0, 4),
        shown(of_body(Name::TrackDepth), 1.0, 4),
        shown(of_contact(Name::PeakPressure), 1.0, 5),
        shown(of_contact(Name::RollingResistance), 1.0, 3),
    )
}
