use brinell::model::Job;
use brinell::solve::*;
use std::time::*;
struct Clock(Instant);
impl Observer for Clock {
    fn elapsed(&self) -> Duration {
        self.0.elapsed()
    }
}
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let base: serde_json::Value =
        serde_json::from_str(include_str!("../api/examples/two_cylinders.json")).unwrap();
    let (lo, hi): (f64, f64) = (a[1].parse().unwrap(), a[2].parse().unwrap());
    let forces: Vec<f64> = (0..20).map(|k| lo + (hi - lo) * k as f64 / 19.0).collect();
    let time = |j: &serde_json::Value| {
        let job = Job::from_value(j).unwrap();
        let mut best = (f64::INFINITY, None);
        for _ in 0..5 {
            let t = Instant::now();
            let s = run(&job, &mut Clock(t)).unwrap();
            let d = 1e3 * t.elapsed().as_secs_f64();
            if d < best.0 {
                best = (d, Some(s));
            }
        }
        (best.0, best.1.unwrap())
    };
    let mut single: f64 = 0.0;
    let mut its = vec![];
    let mut sum = 0.0;
    for f in &forces {
        let mut j = base.clone();
        j["load"] = serde_json::json!({"force":f});
        if a.len() > 3 {
            j["analysis"] = serde_json::json!(a[3]);
        }
        let (d, s) = time(&j);
        single = single.max(d);
        sum += d;
        its.push((s.steps[0].history.len(), s.steps[0].peak_pressure, s.steps[0].approach));
    }
    let mut j = base.clone();
    j["load"] = serde_json::json!({"forces":forces});
    if a.len() > 3 {
        j["analysis"] = serde_json::json!(a[3]);
    }
    let (d, s) = time(&j);
    println!("single max {single:.1} sum {sum:.1} sweep {d:.1} ratio {:.2} passes {}", d / single, s.passes);
    for p in [
        Phase::Mesh,
        Phase::Ordering,
        Phase::Symbolic,
        Phase::Assembly,
        Phase::Numeric,
        Phase::Flexibility,
        Phase::Contact,
        Phase::Plasticity,
        Phase::Solves,
        Phase::Output,
    ] {
        print!(" {:?} {:.2}", p, 1e3 * s.phases.spent(p).as_secs_f64());
    }
    println!();
    for (st, (n, p, al)) in s.steps.iter().zip(its) {
        print!(
            "({} {} {:?} {:.0e} {:.0e}) ",
            n,
            st.history.len(),
            st.status,
            st.peak_pressure / p - 1.0,
            st.approach / al - 1.0
        );
    }
    println!();
}
