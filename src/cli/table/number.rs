//! Figures with as many digits as they deserve.

/// Writes a number with this many significant digits; very large and very small ones in powers of
/// ten.
pub(in crate::cli) fn significant(value: f64, digits: i32) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let magnitude = value.abs().log10().floor();
    if !(-4.0..8.0).contains(&magnitude) {
        let decimals = usize::try_from(digits - 1).unwrap_or(0);
        return format!("{value:.decimals$e}");
    }
    #[expect(clippy::cast_possible_truncation, reason = "between -4 and 8")]
    let decimals = usize::try_from(digits - 1 - magnitude as i32).unwrap_or(0);
    format!("{value:.decimals$}")
}

/// The smallest of 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten that is not below
/// `value`.
pub(super) fn round_up(value: f64) -> f64 {
    let power = 10_f64.powf(value.log10().floor());
    let steps = [1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];
    steps
        .into_iter()
        .map(|step| step * power)
        .find(|step| *step >= value * (1.0 - 1e-12))
        .unwrap_or(value)
}

/// Writes a number without needless digits.
pub(super) fn short(value: f64) -> String {
    let text = significant(value, 4);
    if text.contains('.') && !text.contains('e') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_follow_the_size() {
        assert_eq!(significant(1182.567, 5), "1182.6");
        assert_eq!(significant(0.017_919_3, 5), "0.017919");
        assert_eq!(significant(-612.6106, 7), "-612.6106");
        assert_eq!(significant(1.182_567e9, 5), "1.1826e9");
        assert_eq!(significant(1.0179e-5, 5), "1.0179e-5");
        assert_eq!(significant(1.2e-7, 3), "1.20e-7");
        assert_eq!(short(210_000.0), "210000");
        assert_eq!(short(0.3), "0.3");
    }

    #[test]
    fn axes_end_on_round_numbers() {
        for (value, round) in [(1182.6, 1200.0), (0.416, 0.5), (1.0, 1.0), (0.0025, 0.0025)] {
            assert!((round_up(value) - round).abs() < 1e-12 * round, "{value}");
        }
    }
}
