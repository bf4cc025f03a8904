//! Scales of hardness.

/// Smallest and largest hardness of the table \[HRC\].
pub const ROCKWELL_C_RANGE: (f64, f64) = (20.3, 68.0);

/// Rockwell C and Vickers hardness of unalloyed and low-alloy steels and cast steel. Other steels
/// are off by one to two HRC.
///
/// # Reference
/// ISO 18265:2013, *Metallic materials – Conversion of hardness values*, table A.1, which is that
/// of DIN 50150.
#[rustfmt::skip]
pub const ROCKWELL_C: [[f64; 2]; 63] = [
    [20.3, 240.0], [21.3, 245.0], [22.2, 250.0], [23.1, 255.0], [24.0, 260.0], [24.8, 265.0],
    [25.6, 270.0], [26.4, 275.0], [27.1, 280.0], [27.8, 285.0], [28.5, 290.0], [29.2, 295.0],
    [29.8, 300.0], [31.0, 310.0], [32.2, 320.0], [33.3, 330.0], [34.4, 340.0], [35.5, 350.0],
    [36.6, 360.0], [37.7, 370.0], [38.8, 380.0], [39.8, 390.0], [40.8, 400.0], [41.8, 410.0],
    [42.7, 420.0], [43.6, 430.0], [44.5, 440.0], [45.3, 450.0], [46.1, 460.0], [46.9, 470.0],
    [47.7, 480.0], [48.4, 490.0], [49.1, 500.0], [49.8, 510.0], [50.5, 520.0], [51.1, 530.0],
    [51.7, 540.0], [52.3, 550.0], [53.0, 560.0], [53.6, 570.0], [54.1, 580.0], [54.7, 590.0],
    [55.2, 600.0], [55.7, 610.0], [56.3, 620.0], [56.8, 630.0], [57.3, 640.0], [57.8, 650.0],
    [58.3, 660.0], [58.8, 670.0], [59.2, 680.0], [59.7, 690.0], [60.1, 700.0], [61.0, 720.0],
    [61.8, 740.0], [62.5, 760.0], [63.3, 780.0], [64.0, 800.0], [64.7, 820.0], [65.3, 840.0],
    [65.9, 860.0], [67.0, 900.0], [68.0, 940.0],
];

/// Returns the Vickers hardness of a Rockwell C hardness, straight between the rows of
/// [`ROCKWELL_C`]; `None` beyond them.
pub fn vickers_of_rockwell_c(hardness: f64) -> Option<f64> {
    let (low, high) = ROCKWELL_C_RANGE;
    if !(low..=high).contains(&hardness) {
        return None;
    }
    let next = ROCKWELL_C.partition_point(|row| row[0] < hardness).max(1);
    let ([c0, v0], [c1, v1]) = (ROCKWELL_C[next - 1], ROCKWELL_C[next]);
    Some(v0 + (v1 - v0) * (hardness - c0) / (c1 - c0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_rise_and_are_met() {
        assert!(ROCKWELL_C.windows(2).all(|r| r[1][0] > r[0][0] && r[1][1] > r[0][1]));
        assert_eq!((ROCKWELL_C[0][0], ROCKWELL_C[62][0]), ROCKWELL_C_RANGE);
        for [rockwell, vickers] in ROCKWELL_C {
            assert!((vickers_of_rockwell_c(rockwell).unwrap() - vickers).abs() < 1e-9);
        }
        assert_eq!((vickers_of_rockwell_c(20.2), vickers_of_rockwell_c(68.1)), (None, None));
        assert!(vickers_of_rockwell_c(f64::NAN).is_none());
    }

    /// Another table, of another set of steels: ASTM E 140, table 1.
    #[test]
    fn agrees_with_another_table_within_a_hundredth() {
        for (rockwell, vickers) in [
            (30.0, 302.0),
            (40.0, 392.0),
            (45.0, 446.0),
            (50.0, 513.0),
            (55.0, 595.0),
            (60.0, 697.0),
            (64.0, 800.0),
        ] {
            let found = vickers_of_rockwell_c(rockwell).unwrap();
            assert!((found / vickers - 1.0).abs() < 0.01, "{rockwell} HRC: {found}");
        }
    }
}
