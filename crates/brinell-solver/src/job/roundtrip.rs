//! Any job written to the wire format and read back is the same job.

use proptest::prelude::*;
use serde::Deserialize;

use super::reader::Node;
use super::strategy::job;
use super::*;

/// Compares two jobs in mm: numbers agree to a few units in the last place, all other values are
/// equal.
fn assert_close(left: &serde_json::Value, right: &serde_json::Value) {
    use serde_json::Value;
    match (left, right) {
        (Value::Number(left), Value::Number(right)) => {
            let (left, right) = (left.as_f64().unwrap(), right.as_f64().unwrap());
            assert!((left - right).abs() <= 1e-15 * left.abs(), "{left:e} became {right:e}");
        }
        (Value::Array(left), Value::Array(right)) => {
            assert_eq!(left.len(), right.len());
            left.iter().zip(right).for_each(|(left, right)| assert_close(left, right));
        }
        (Value::Object(left), Value::Object(right)) => {
            assert!(left.keys().eq(right.keys()));
            left.iter().for_each(|(key, left)| assert_close(left, &right[key]));
        }
        (left, right) => assert_eq!(left, right),
    }
}

fn in_mm(job: &Job) -> serde_json::Value {
    serde_json::to_value(Job { units: Units::MmNMpa, ..job.clone() }).unwrap()
}

proptest! {
    #[test]
    fn every_job_survives_its_wire_form(job in job()) {
        let text = serde_json::to_string(&job).unwrap();
        let back = Job::read(&reader::parse(text.as_bytes()).unwrap()).unwrap();
        prop_assert_eq!(back.units, job.units);
        assert_close(&in_mm(&job), &in_mm(&back));
        if job.units == Units::MmNMpa {
            prop_assert_eq!(&back, &job);
        }
        let value = serde_json::to_value(&job).unwrap();
        let by_value = Job::read(&Node::deserialize(&value).unwrap()).unwrap();
        assert_close(&in_mm(&job), &in_mm(&by_value));
    }

    #[test]
    fn a_change_of_units_is_the_same_job(job in job()) {
        let other = if job.units == Units::Si { Units::MmNMpa } else { Units::Si };
        let written = serde_json::to_string(&Job { units: other, ..job.clone() }).unwrap();
        let back = Job::read(&reader::parse(written.as_bytes()).unwrap()).unwrap();
        assert_close(&in_mm(&job), &in_mm(&back));
    }
}

/// The schema of a job in the document of the service.
fn schema() -> (boon::Schemas, boon::SchemaIndex) {
    let document = include_str!("../../../../api/openapi.json");
    let document = serde_json::from_str(document).unwrap();
    let mut compiler = boon::Compiler::new();
    compiler.add_resource("file:///openapi.json", document).unwrap();
    let mut schemas = boon::Schemas::new();
    let job = "file:///openapi.json#/components/schemas/ContactJob";
    let index = compiler.compile(job, &mut schemas).unwrap();
    (schemas, index)
}

#[test]
fn whatever_the_format_can_say_is_in_the_schema() {
    let (schemas, index) = schema();
    proptest!(|(job in job())| {
        let job = serde_json::to_value(job).unwrap();
        let faults = schemas.validate(&job, index).err().map(|fault| fault.to_string());
        prop_assert!(faults.is_none(), "{:?} in {job}", faults);
    });
}

/// Every place of a document.
fn pointers(value: &serde_json::Value, at: &str, found: &mut Vec<String>) {
    use serde_json::Value;
    found.push(at.to_owned());
    match value {
        Value::Object(members) => {
            members.iter().for_each(|(key, one)| {
                let key = key.replace('~', "~0").replace('/', "~1");
                pointers(one, &format!("{at}/{key}"), found);
            });
        }
        Value::Array(items) => {
            items.iter().zip(0..).for_each(|(one, k)| pointers(one, &format!("{at}/{k}"), found));
        }
        _ => {}
    }
}

proptest! {
    /// A long text at any place is repeated with its beginning only.
    #[test]
    fn a_fault_repeats_little_of_the_job(job in job(), place: prop::sample::Index) {
        let long = "x".repeat(10_000);
        let whole = serde_json::to_value(&job).unwrap();
        let mut places = Vec::new();
        pointers(&whole, "", &mut places);
        let place = place.get(&places);
        let mut text = whole.clone();
        *text.pointer_mut(place).unwrap() = long.clone().into();
        let mut key = whole;
        if let Some(members) = key.pointer_mut(place).unwrap().as_object_mut() {
            members.insert(long, 1.into());
        }
        for spoilt in [text, key] {
            let Err(JobError::Fields(faults)) = Job::from_value(&spoilt) else { continue };
            for fault in faults {
                prop_assert!(fault.detail.len() < 400 && fault.pointer.len() < 200, "{fault:?}");
            }
        }
    }
}

#[test]
fn words_are_those_that_are_serialized() {
    fn check<T: Named + serde::Serialize>() {
        for value in T::ALL {
            assert_eq!(serde_json::to_value(value).unwrap(), value.name());
        }
    }
    check::<Analysis>();
    check::<Units>();
    check::<FarSupport>();
    check::<Coupling>();
    check::<ContactMethod>();
}

#[test]
fn a_former_word_is_read_and_not_written() {
    let example = include_str!("../../../../api/examples/paper_cylinders.json");
    let read = |text: &str| Job::from_json(text.as_bytes()).unwrap();
    let former = read(&example.replace("\"jiang_shang\"", "\"paper\""));
    assert_eq!(former, read(example));
    assert_eq!(serde_json::to_value(&former).unwrap()["solver"]["method"], "jiang_shang");
}
