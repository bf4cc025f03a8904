//! Parsers of the values of flags.

use std::time::Duration;

use axum::http::{HeaderValue, Uri};

/// Units of times, in seconds.
const UNITS: [(&str, f64); 5] =
    [("ms", 1e-3), ("s", 1.0), ("m", 60.0), ("h", 3600.0), ("d", 86400.0)];

/// Reads a positive number of seconds, or a time such as `500ms`, `1s`, `5m`, up to about three
/// years.
pub(super) fn seconds(text: &str) -> Result<Duration, String> {
    time(text, 1.0, "seconds")
}

/// Reads a positive number of hours, or a time such as `30m`, `7d`, up to about three years.
pub(super) fn hours(text: &str) -> Result<Duration, String> {
    time(text, 3600.0, "hours")
}

/// Reads a number of connections, at least one.
pub(super) fn connections(text: &str) -> Result<usize, String> {
    let value: Option<usize> = text.parse().ok();
    value
        .filter(|value| *value > 0)
        .ok_or_else(|| "must be a whole number greater than 0".to_owned())
}

/// Reads a positive rate.
pub(super) fn rate(text: &str) -> Result<f64, String> {
    let value: Option<f64> = text.parse().ok();
    let message = "must be a number greater than 0 and at most 1000000";
    value.filter(|value| *value > 0.0 && *value <= 1e6).ok_or_else(|| message.to_owned())
}

/// Reads an origin, `https://design.example` or `https://design.example:8443`, or `*`.
pub(super) fn origin(text: &str) -> Result<HeaderValue, String> {
    let is_origin = text == "*"
        || text.parse::<Uri>().is_ok_and(|uri| {
            let scheme = uri.scheme_str();
            matches!(scheme, Some("http" | "https"))
                && uri.path() == "/"
                && uri.query().is_none()
                && !text.ends_with('/')
        });
    let message =
        || "must be scheme://host or scheme://host:port, without a path, or *".to_owned();
    if is_origin { HeaderValue::try_from(text).map_err(|_| message()) } else { Err(message()) }
}

/// Reads the origin of one service.
pub(super) fn own_origin(text: &str) -> Result<HeaderValue, String> {
    origin(text)
        .ok()
        .filter(|origin| origin != "*")
        .ok_or_else(|| "must be scheme://host or scheme://host:port, without a path".to_owned())
}

fn time(text: &str, unit: f64, name: &str) -> Result<Duration, String> {
    let with_unit = UNITS.iter().find_map(|(end, unit)| Some((text.strip_suffix(end)?, *unit)));
    let (number, unit) =
        with_unit.filter(|(number, _)| number.parse::<f64>().is_ok()).unwrap_or((text, unit));
    let value: f64 = number
        .trim_end()
        .parse()
        .map_err(|_| format!("must be a number of {name}, or a time such as 5m"))?;
    if value > 0.0 && value * unit <= 1e8 {
        Ok(Duration::from_secs_f64(value * unit))
    } else {
        Err("must be greater than 0 and at most about three years".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_must_be_positive() {
        assert_eq!(seconds("0.5"), Ok(Duration::from_millis(500)));
        assert_eq!(hours("0.5"), Ok(Duration::from_mins(30)));
        let minutes = Duration::from_mins(5);
        assert_eq!(
            [seconds("5m"), hours("5m"), seconds("300s"), hours("300000ms")],
            [(); 4].map(|()| Ok(minutes))
        );
        assert_eq!(hours("7d"), Ok(Duration::from_hours(168)));
        for text in
            ["0", "-1", "NaN", "inf", "soon", "1e9", "", "s", "m", "-5m", "5 weeks", "infs"]
        {
            assert!(seconds(text).is_err(), "{text}");
            assert!(hours(text).is_err(), "{text}");
        }
    }

    #[test]
    fn an_origin_has_no_path() {
        for text in ["*", "https://design.example", "http://localhost:3000"] {
            assert!(origin(text).is_ok(), "{text}");
            assert_eq!(own_origin(text).is_ok(), text != "*");
        }
        for text in [
            "",
            "design.example",
            "https://design.example/",
            "https://design.example/app",
            "ftp://a.example",
        ] {
            assert!(origin(text).is_err(), "{text}");
        }
    }
}
