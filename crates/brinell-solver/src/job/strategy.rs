//! A proptest strategy that generates any job of the wire format.

use std::collections::BTreeMap;

use proptest::collection::{btree_map, vec};
use proptest::prelude::*;

use serde::Deserialize;

use super::fields::{Example, FieldKind};
use super::reader::{Cursor, Faults, Node};
use super::{
    Analysis, BackstressTerm, Body, ContactMethod, Coupling, Deformable, Elastic, FarSupport,
    Field, FieldTable, Hardening, HardeningRule, History, HistoryLoad, Job, Load, Material,
    MeshSettings, Method, Named, NonNegativeF64, OutputSettings, PoissonRatio, PositiveF64,
    Rolling, Shape, SolverSettings, Sweep, Target, TargetFigure, Theory, Units, Until, target,
};

/// Generates a positive number within two decades of a typical one, which is in range in both unit
/// systems.
fn near(typical: f64) -> impl Strategy<Value = PositiveF64> {
    (-2.0..2.0_f64)
        .prop_map(move |decades| PositiveF64::new(typical * 10_f64.powf(decades)).unwrap())
}

fn between(low: f64, high: f64) -> impl Strategy<Value = PositiveF64> {
    (low..=high).prop_map(|value| PositiveF64::new(value).unwrap())
}

/// Generates an object of one of these tables. Every figure lies near its typical value; an object
/// that breaks a rule between figures is drawn again.
fn any_of_tables<T: std::fmt::Debug>(
    tag: &'static str,
    tables: &'static [FieldTable],
    read: fn(Cursor<'_>) -> Option<T>,
) -> impl Strategy<Value = T> {
    let one = |table: &'static FieldTable| {
        let members: Vec<_> = table
            .fields
            .iter()
            .map(|field| member(field).prop_map(|value| (field.key, value)))
            .collect();
        members.prop_map(move |members| {
            let mut object: serde_json::Map<_, _> = members
                .into_iter()
                .filter_map(|(key, value)| Some((key.to_owned(), value?)))
                .collect();
            object.insert(tag.to_owned(), table.word.into());
            serde_json::Value::Object(object)
        })
    };
    let any = proptest::strategy::Union::new(tables.iter().map(one));
    any.prop_filter_map("a rule between figures is broken", move |object| {
        let (node, faults) = (Node::deserialize(&object).unwrap(), Faults::default());
        read(Cursor::root(&node, &faults))
    })
}

/// Generates the value of a field. Leaves out an optional field now and then, and always if it has
/// no typical value.
fn member(field: &'static Field) -> BoxedStrategy<Option<serde_json::Value>> {
    match (field.required, &field.kind, field.example) {
        (true, ..) => value(field).prop_map(Some).boxed(),
        (false, FieldKind::Figure(_) | FieldKind::Points { .. }, Example::None) => {
            Just(None).boxed()
        }
        (false, ..) => proptest::option::of(value(field)).boxed(),
    }
}

/// Generates the value of one field in the wire format, within two decades of the typical value
/// and in range in both unit systems.
fn value(field: &'static Field) -> BoxedStrategy<serde_json::Value> {
    match (&field.kind, field.example) {
        (FieldKind::Choice(_, words), _) => {
            proptest::sample::select(words()).prop_map(serde_json::Value::from).boxed()
        }
        (FieldKind::Figure(figure), Example::Figure(typical)) => {
            let (low, high) = figure.range();
            let drawn = (-2.0..2.0_f64).prop_map(move |decades| typical * 10_f64.powf(decades));
            drawn.prop_map(move |value| value.clamp(low, high).into()).boxed()
        }
        // Points whose columns rise from the first point on, as the typical points do.
        (FieldKind::Points { count, .. }, Example::Points(typical)) => {
            let first = typical[0];
            let step = move |axis: usize| {
                typical.iter().map(|point| point[axis] - first[axis]).fold(0.0, f64::max)
            };
            vec((0.01..1.0_f64, 0.0..1.0_f64), *count.start()..20)
                .prop_map(move |steps| {
                    let (mut point, mut points) = (first, Vec::new());
                    for (x, y) in steps {
                        points.push(point);
                        point = [point[0] + x * step(0), point[1] + y * step(1)];
                    }
                    serde_json::json!(points)
                })
                .boxed()
        }
        _ => panic!("{} has no example", field.key),
    }
}

fn shape() -> impl Strategy<Value = Shape> {
    any_of_tables(Shape::TAG, Shape::TABLES, |cursor| {
        Shape::read(cursor, Some(Units::MmNMpa), &[])
    })
}

fn curve() -> impl Strategy<Value = Hardening> {
    any_of_tables(Hardening::TAG, Hardening::TABLES, |cursor| {
        Hardening::read(cursor, Some(Units::MmNMpa), &[])
    })
}

fn deformable() -> impl Strategy<Value = Material> {
    let constants =
        (near(10_000.0), (0.0..0.5).prop_map(|ratio| PoissonRatio::new(ratio).unwrap()));
    let elastic = constants
        .prop_map(|(young_modulus, poisson_ratio)| Elastic { young_modulus, poisson_ratio });
    let term = (near(10_000.0), prop_oneof![Just(0.0), 1.0..1e3]).prop_map(|(modulus, rate)| {
        BackstressTerm { modulus, rate: NonNegativeF64::new(rate).unwrap() }
    });
    let terms = vec(term, 0..=BackstressTerm::MAX_TERMS);
    (elastic, proptest::option::of(curve()), terms).prop_filter_map(
        "too steep",
        |(elastic, curve, terms)| {
            let beside = [("young_modulus", elastic.young_modulus.get())];
            let is_steep = curve.as_ref().is_some_and(|law| !law.faults(&beside).is_empty());
            let backstress = if curve.is_some() { terms } else { Vec::new() };
            let material = Deformable { backstress, ..Deformable::new(elastic, curve) };
            (!is_steep).then_some(Material::Deformable(material))
        },
    )
}

fn body(material: impl Strategy<Value = Material>) -> impl Strategy<Value = Body> {
    let all = (shape(), material, named(), any_of(FarSupport::ALL));
    all.prop_map(|(shape, material, material_name, support)| {
        let surface = None;
        Body { shape, material, material_name, support, surface }
    })
}

/// A name, or none.
fn named() -> impl Strategy<Value = Option<String>> {
    proptest::option::of("[A-Za-zµ][ -~]{0,79}")
}

fn any_of<T: Named + std::fmt::Debug>(all: &'static [T]) -> impl Strategy<Value = T> {
    proptest::sample::select(all)
}

fn history() -> impl Strategy<Value = History> {
    let zero = || Just(NonNegativeF64::new(0.0).unwrap());
    let positive =
        |typical| near(typical).prop_map(|value| NonNegativeF64::new(value.get()).unwrap());
    let entry = prop_oneof![
        prop_oneof![positive(600.0), zero()].prop_map(HistoryLoad::Force),
        prop_oneof![positive(0.02), zero()].prop_map(HistoryLoad::Approach),
    ];
    let first = positive(600.0).prop_map(HistoryLoad::Force);
    (first, vec(entry, 0..10)).prop_map(|(first, rest)| {
        History::new(std::iter::once(first).chain(rest).collect()).unwrap()
    })
}

fn sought() -> impl Strategy<Value = Target> {
    any_of(TargetFigure::ALL).prop_flat_map(|figure| {
        near(target::example(figure)).prop_map(move |value| Target { figure, value })
    })
}

fn rolling() -> impl Strategy<Value = Rolling> {
    let ends = (1..=100_u32, any_of(Until::ALL), any::<bool>(), any_of(HardeningRule::ALL));
    (near(2000.0), ends, -1.0..=1.0, proptest::option::of(8.0..=256.0)).prop_map(
        |(force, (passes, until, alternating, hardening), friction, track)| Rolling {
            force,
            passes,
            until,
            friction,
            alternating,
            track,
            hardening,
        },
    )
}

fn load() -> impl Strategy<Value = Load> {
    let sweep = |typical| vec(near(typical), 1..20).prop_map(|values| Sweep::new(values).unwrap());
    prop_oneof![
        sweep(600.0).prop_map(Load::Forces),
        sweep(0.02).prop_map(Load::Approaches),
        history().prop_map(Load::History),
        Just(Load::Onset),
        sought().prop_map(Load::Target),
        rolling().prop_map(Load::Rolling)
    ]
}

fn settings() -> impl Strategy<Value = (MeshSettings, SolverSettings, OutputSettings)> {
    let theory = (any_of(Theory::ALL), proptest::option::of(1..=10_000_u32));
    let methods = (any_of(Coupling::ALL), any_of(ContactMethod::ALL));
    let solver = (theory, methods, between(1e-12, 1e-1), 1..=100_000_u32);
    let solver = solver.prop_map(
        |((theory, increments), (coupling, contact), tolerance, max_iterations)| {
            let method = Method::Standard;
            SolverSettings {
                method,
                theory,
                increments,
                coupling,
                contact,
                tolerance,
                max_iterations,
            }
        },
    );
    let accuracy = proptest::option::of(
        (1e-3..=0.2).prop_map(|value| PositiveF64::new(value).unwrap_or(PositiveF64::MICRO)),
    );
    let mesh = (4..=320_u32, accuracy).prop_map(|(elements_per_half_width, accuracy)| {
        MeshSettings { elements_per_half_width, accuracy }
    });
    let output = any::<[bool; 3]>().prop_map(|[subsurface, fields, contact_stiffness]| {
        OutputSettings { subsurface, fields, contact_stiffness }
    });
    (mesh, solver, output)
}

fn tags() -> impl Strategy<Value = BTreeMap<String, String>> {
    btree_map("[a-zé/~ ]{1,64}", "[^\\p{Cc}]{0,256}", 0..5)
}

/// Generates any job of the wire format, solvable or not.
pub fn job() -> impl Strategy<Value = Job> {
    let lower = prop_oneof![4 => deformable(), 1 => Just(Material::Rigid)];
    let bodies = (body(deformable()), body(lower), any::<bool>());
    let kinds = (any_of(Analysis::ALL), any_of(Units::ALL));
    let names = (named(), tags());
    (kinds, bodies, load(), settings(), names).prop_map(
        |((analysis, units), (one, other, swap), load, (mesh, solver, output), (title, tags))| {
            let (upper, lower) = if swap { (other, one) } else { (one, other) };
            let (find, tolerances) = (None, Vec::new());
            Job {
                title,
                analysis,
                units,
                upper,
                lower,
                load,
                find,
                tolerances,
                mesh,
                solver,
                output,
                tags,
            }
        },
    )
}
