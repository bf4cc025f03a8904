//! The figures of worked examples in `docs/`, between `<!-- computed: NAME -->` and `<!-- end -->`.

mod case_hardened_roller;
mod example;
mod fatigue;
mod rolling_bearing;
mod static_rating;

pub use example::Example;

pub const EXAMPLES: [Example; 4] = [
    static_rating::EXAMPLE,
    case_hardened_roller::EXAMPLE,
    rolling_bearing::EXAMPLE,
    fatigue::EXAMPLE,
];
