//! Example jobs.

/// Every file in `api/examples`.
pub(crate) const EXAMPLES: [(&str, &str); 17] = [
    ("two_cylinders", include_str!("../../api/examples/two_cylinders.json")),
    ("cylinder_on_block", include_str!("../../api/examples/cylinder_on_block.json")),
    ("ramberg_osgood", include_str!("../../api/examples/ramberg_osgood.json")),
    ("case_hardened_roller", include_str!("../../api/examples/case_hardened_roller.json")),
    ("peened_roller", include_str!("../../api/examples/peened_roller.json")),
    ("pin_in_hole", include_str!("../../api/examples/pin_in_hole.json")),
    ("static_rating_roller", include_str!("../../api/examples/static_rating_roller.json")),
    ("static_rating_ball", include_str!("../../api/examples/static_rating_ball.json")),
    ("ball_in_raceway", include_str!("../../api/examples/ball_in_raceway.json")),
    ("ellipse_dent", include_str!("../../api/examples/ellipse_dent.json")),
    ("tilted_roller", include_str!("../../api/examples/tilted_roller.json")),
    ("rail_under_driven_wheel", include_str!("../../api/examples/rail_under_driven_wheel.json")),
    ("rolled_hardened_roller", include_str!("../../api/examples/rolled_hardened_roller.json")),
    ("ball_runs_in", include_str!("../../api/examples/ball_runs_in.json")),
    ("deep_rolling", include_str!("../../api/examples/deep_rolling.json")),
    ("paper_cylinders", include_str!("../../api/examples/paper_cylinders.json")),
    ("brinell_test", include_str!("../../api/examples/brinell_test.json")),
];
