//! `GET /v1/jobs/{id}/summary.csv`, `pressure.csv`, `subsurface.csv`, `increments.csv`, …: the
//! result in the forms that other programs read.
//!
//! The tables hold every step of a sweep and name it in a column. The others show one step, the
//! last one unless `?step=` names another, counted from 1 as in the tables.

use axum::extract::State;
use axum::response::Response;
use axum::routing::get;
use brinell_solver::job::Named as _;
use utoipa::IntoParams;
use utoipa::openapi::extensions::ExtensionsBuilder;
use utoipa::openapi::header::HeaderBuilder;
use utoipa::openapi::path::{
    Operation, OperationBuilder, Parameter, ParameterBuilder, ParameterIn, Paths,
};
use utoipa::openapi::schema::{ObjectBuilder, Type};
use utoipa::openapi::{Content, HttpMethod, Ref, Required, ResponseBuilder};
use utoipa_axum::router::UtoipaMethodRouter;

use crate::http::access::Caller;
use crate::http::export_file::export_file;
use crate::http::job_path::JobPath;
use crate::http::query::Step;
use crate::http::{HttpState, Problem};
use crate::jobs::Export;

/// One route for each form, declared as it is served.
pub(in crate::http) fn exports() -> impl Iterator<Item = UtoipaMethodRouter<HttpState>> {
    Export::ALL.iter().map(|&form| {
        let mut paths = Paths::new();
        let path = format!("/v1/jobs/{{id}}/{}", form.name());
        paths.add_path_operation(path, vec![HttpMethod::Get], operation(form));
        (
            Vec::new(),
            paths,
            get(move |state, caller, job, step| get_export(state, caller, job, step, form)),
        )
    })
}

fn operation(form: Export) -> Operation {
    let (summary, lacking) = match form {
        Export::SummaryCsv => ("One row of figures for each step, as a table", None),
        Export::PressureCsv => ("Contact pressure of all steps, as a table", None),
        Export::SubsurfaceCsv => {
            ("Stresses over depth of all steps, as a table", Some("not-in-result"))
        }
        Export::IncrementsCsv => {
            ("Every increment of a history, as a table", Some("not-in-result"))
        }
        Export::HardnessCsv => {
            ("Load-displacement curve of a hardness test, as a table", Some("not-in-result"))
        }
        Export::FatigueCsv => {
            ("Utilization over depth by criteria of fatigue, as a table", Some("not-in-result"))
        }
        Export::PassesCsv => ("Passes of a load that rolls, as a table", Some("not-in-result")),
        Export::SurfaceCsv => {
            ("Surfaces of all steps, the dent among them, as a table", Some("not-in-result"))
        }
        Export::FieldVtu => {
            ("Mesh and fields of both bodies, for ParaView", Some("not-in-result"))
        }
        Export::FieldVtr => (
            "Stress and plastic strain in layers, in three dimensions, of a track in its section, for \
             ParaView",
            Some("not-in-result"),
        ),
        Export::PressureSvg => ("Contact pressure with Hertz's beside it, drawn", None),
        Export::DepthSvg => {
            ("Stresses over depth with McEwen's beside them, drawn", Some("not-in-result"))
        }
        Export::LoadApproachSvg => {
            ("Force over approach of all increments, drawn", Some("not-in-result"))
        }
        Export::SurfaceSvg => {
            ("Surfaces of both bodies: the dent and its pile-up, drawn", Some("not-in-result"))
        }
    };
    let problems = ["job-unfinished", "no-result"]
        .into_iter()
        .chain(lacking)
        .chain(form.shows_one_step().then_some("step-not-found"));
    let id = ParameterBuilder::new()
        .name("id")
        .parameter_in(ParameterIn::Path)
        .required(Required::True)
        .description(Some("The job's id, as its `Location` has it."))
        .schema(Some(Ref::from_schema_name("JobId")));
    let step = Step::into_params(|| None);
    let step = step.into_iter().filter(|_| form.shows_one_step());
    let parameters: Vec<Parameter> = [id.build()].into_iter().chain(step).collect();
    let media_type = form.media_type().split(';').next().unwrap_or_default();
    let text = ObjectBuilder::new().schema_type(Type::String);
    let answer = ResponseBuilder::new()
        .description("The file.")
        .header(
            "Content-Disposition",
            HeaderBuilder::new().description(Some("A name for the file.")).build(),
        )
        .content(media_type, Content::new(Some(text)));
    OperationBuilder::new()
        .operation_id(Some(format!("get_{}", form.name().replace('.', "_"))))
        .tag("results")
        .summary(Some(summary))
        .parameters(Some(parameters))
        .response("200", answer)
        .extensions(Some(
            ExtensionsBuilder::new().add("x-problems", problems.collect::<Vec<_>>()).build(),
        ))
        .build()
}

async fn get_export(
    State(state): State<HttpState>,
    caller: Caller,
    JobPath(id): JobPath,
    Step(step): Step,
    form: Export,
) -> Result<Response, Problem> {
    export_file(&state, caller, id, form, step).await
}
