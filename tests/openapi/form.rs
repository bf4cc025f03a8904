//! The tables of the page's form, from those that read and write a job.

use std::fmt::Write;

use brinell_solver::job::fields::{Example, Field, FieldKind, FieldTable, NumberKind};
use brinell_solver::job::{Domain, Hardening, InitialStress, OverDepth, Shape};
use brinell_solver::material::hardness;
use serde_json::{Value, json};

const HEAD: &str = "\
/**
 * The fields of every shape and hardening law, as the service reads them. Generated from the
 * tables of the solver: `BRINELL_WRITE=1 cargo test --test openapi`.
 */

/* prettier-ignore */
";

pub fn tables() -> String {
    let mut text = HEAD.to_owned();
    table(&mut text, "SHAPES", Shape::TABLES);
    text += "\n/* prettier-ignore */\n";
    table(&mut text, "LAWS", Hardening::TABLES);
    text += "\n/* prettier-ignore */\n";
    over_depth(&mut text);
    text += "\n/* prettier-ignore */\n";
    initial_stress(&mut text);
    text += "\n/* prettier-ignore */\n";
    rockwell(&mut text);
    text
}

/// The table of hardness, of which the page shows what it takes.
fn rockwell(text: &mut String) {
    text.push_str(
        "/** Rockwell C and Vickers hardness, ISO 18265, table A.1. @type {[number, number][]} */\n",
    );
    writeln!(text, "export const ROCKWELL = {};", json!(hardness::ROCKWELL_C[..])).unwrap();
}

/// The ways to give strength over depth, with keys from the hardening law on.
fn over_depth(text: &mut String) {
    let name =
        "/** @type {Record<string, import('./field.js').Kind>} */\nexport const OVER_DEPTH = {";
    writeln!(text, "{name}").unwrap();
    for (word, label, place, fields) in OverDepth::kinds() {
        writeln!(text, "  {word}: {{\n    label: {},\n    fields: [", json!(label)).unwrap();
        for one in fields {
            let mut entry = field(one);
            if one.key != OverDepth::KEY {
                entry["key"] = json!(format!("{}{place}/{}", OverDepth::KEY, one.key));
            }
            writeln!(text, "      {entry},").unwrap();
        }
        writeln!(text, "    ],\n  }},").unwrap();
    }
    text.push_str("};\n");
}

/// The rows of initial stress, whose members are the columns of one field.
fn initial_stress(text: &mut String) {
    let (table, fields) = (InitialStress::table(), InitialStress::table().fields);
    let figure = |field: &Field| match &field.kind {
        FieldKind::Figure(figure) => quantity(figure),
        _ => panic!("{} is no figure", field.key),
    };
    let entry = json!({
        "key": InitialStress::KEY,
        "label": table.label,
        "symbol": fields.iter().map(|field| field.symbol).collect::<Vec<_>>().join(", "),
        "description": table.description,
        "kind": "terms",
        "columns": fields.iter().map(figure).collect::<Vec<_>>(),
        "members": fields.iter().map(|field| field.key).collect::<Vec<_>>(),
        "optional": true,
    });
    writeln!(
        text,
        "/** @type {{import('./field.js').Field}} */\nexport const INITIAL_STRESS = {entry};"
    )
    .unwrap();
}

fn table(text: &mut String, name: &str, kinds: &[FieldTable]) {
    writeln!(
        text,
        "/** @type {{Record<string, import('./field.js').Kind>}} */\nexport const {name} = {{"
    )
    .unwrap();
    for kind in kinds {
        let (label, description) = (json!(kind.label), json!(kind.description));
        writeln!(
            text,
            "  {}: {{\n    label: {label},\n    description: {description},\n    fields: [",
            kind.word
        )
        .unwrap();
        for one in kind.fields {
            writeln!(text, "      {},", field(one)).unwrap();
        }
        writeln!(text, "    ],\n  }},").unwrap();
    }
    text.push_str("};\n");
}

fn field(field: &Field) -> Value {
    let mut entry = json!({
        "key": field.key,
        "label": field.label,
        "symbol": field.symbol,
        "description": field.description,
    });
    match &field.kind {
        FieldKind::Figure(figure) => entry["quantity"] = json!(quantity(figure)),
        FieldKind::Points { columns: [(_, first), (_, second)], .. } => {
            entry["kind"] = json!("points");
            entry["columns"] = json!([quantity(first), quantity(second)]);
        }
        FieldKind::Flag => entry["kind"] = json!("flag"),
        FieldKind::Whole(_) => entry["quantity"] = json!("number"),
        FieldKind::Choice(_, words) => {
            entry["kind"] = json!("choice");
            let choices =
                words().into_iter().map(|word| (word.to_owned(), json!(word.replace('_', " "))));
            entry["choices"] = choices.collect();
        }
    }
    match field.example {
        Example::Figure(figure) => entry["example"] = json!(figure),
        Example::Points(points) => entry["example"] = json!(points),
        Example::None => {}
    }
    if !field.required {
        entry["optional"] = json!(true);
    }
    entry
}

/// The page's name of a quantity.
fn quantity(figure: &NumberKind) -> &'static str {
    match figure {
        NumberKind::Quantity(
            Domain::Length | Domain::Position | Domain::Depth | Domain::Approach,
        ) => "length",
        NumberKind::Quantity(
            Domain::Modulus | Domain::TangentModulus | Domain::Stress | Domain::SignedStress,
        ) => "stress",
        NumberKind::Quantity(Domain::LineForce) => "line_force",
        NumberKind::Quantity(Domain::Force) => "force",
        NumberKind::Quantity(Domain::Moment) => "energy",
        NumberKind::Pure(_) => "number",
    }
}
