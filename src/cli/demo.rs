//! `brinell demo`: a job from submission to result, with the reference problem.

use std::io::{self, IsTerminal};
use std::process::ExitCode;
use std::sync::Arc;

use bytes::Bytes;
use clap::Args;
use serde::Deserialize;

use super::client::Client;
use super::common::{NOT_CONVERGED, block_on};
use super::fault::Fault;
use super::input::write_answer;
use super::progress::{PRELIMINARY, ProgressLine};
use super::style::Style;
use super::table::table;
use crate::app::Service;
use crate::config::{ServeConfig, StorageConfig};
use crate::jobs::{CoreSolver, IterationRecord, JobId, JobState};
use crate::lifecycle::stop_on_signal;
use brinell_solver::job::Job;
use brinell_solver::report::Report;
use brinell_solver::solver::SolveStatus;

/// Two equal steel cylinders pressed together to three times their yield stress.
const EXAMPLE: &[u8] = include_bytes!("../../api/examples/two_cylinders.json");

/// Arguments of `brinell demo`.
#[derive(Debug, Args)]
pub(super) struct DemoArgs {
    /// Address and port to listen on; port 0 is any free one
    #[arg(long, value_name = "ADDR", default_value = "127.0.0.1:0")]
    listen: String,

    /// Exit after printing instead of serving on (as without a terminal)
    #[arg(long)]
    once: bool,
}

#[derive(Debug, Deserialize)]
struct Submitted {
    id: JobId,
    links: Links,
}

#[derive(Debug, Deserialize)]
struct Links {
    #[serde(rename = "self")]
    job: String,
}

#[derive(Debug, Deserialize)]
struct Status {
    status: JobState,
    progress: Progress,
}

#[derive(Debug, Deserialize)]
struct Progress {
    iterations: usize,
    latest: Option<IterationRecord>,
}

pub(super) fn demo(args: &DemoArgs) -> Result<ExitCode, Fault> {
    block_on(async {
        let stop = stop_on_signal()?;
        let storage = StorageConfig { data_dir: ":memory:".into(), ..StorageConfig::default() };
        let config =
            ServeConfig { listen: args.listen.clone(), storage, ..ServeConfig::default() };
        let service =
            Service::bind(&config, Arc::new(CoreSolver::with_cache(config.work.factor_cache())))
                .await?;
        let client = Client::new(service.address());
        let server = tokio::spawn(service.run(stop.clone()));
        let (job, report) = tokio::select! {
            shown = show_a_job(&client) => shown?,
            () = stop.cancelled() => return Ok(ExitCode::SUCCESS),
        };
        let serve_on = !args.once && io::stdin().is_terminal();
        say(&farewell(&client, job, serve_on))?;
        if !serve_on {
            stop.cancel();
        }
        server.await.map_err(|error| Fault::Demo(error.to_string()))??;
        let converged = report.status == SolveStatus::Converged;
        Ok(if converged { ExitCode::SUCCESS } else { ExitCode::from(NOT_CONVERGED) })
    })
}

/// Submits the example, follows it and prints its result.
async fn show_a_job(client: &Client) -> Result<(JobId, Report), Fault> {
    let style = Style::of_stdout();
    let job = Job::from_json(EXAMPLE).map_err(|error| Fault::of_job("the example", error))?;
    say(&format!("POST http://{}/v1/jobs (api/examples/two_cylinders.json)\n", client.address))?;
    let submitted: Submitted = client.post("/v1/jobs", Bytes::from_static(EXAMPLE)).await?;
    say(&format!("202 {}\n", submitted.links.job))?;
    let mut progress = ProgressLine::impatient();
    let state = loop {
        let job: Status = client.get(&format!("{}?wait=0.05", submitted.links.job)).await?;
        if let Some(record) = &job.progress.latest {
            let before = if job.progress.iterations == 0 { PRELIMINARY } else { "" };
            progress.show(before, record);
        }
        if job.status.is_finished() {
            break job.status;
        }
    };
    drop(progress);
    let address = format!("{}/result", submitted.links.job);
    say(&format!("GET {address}\n200 {state}\n\n"))?;
    let report: Report = client.get(&address).await?;
    say(&table(&job, &report, None, style))?;
    Ok((submitted.id, report))
}

fn farewell(client: &Client, job: JobId, serves_on: bool) -> String {
    let url = format!("http://{}", client.address);
    if serves_on {
        format!(
            "\nThe service listens until Ctrl-C. This contact in a browser, to look at and to \
             change:\n\n  \
             {url}/#job={job}\n\nor ask the service yourself:\n\n  \
             curl {url}/v1/solve -H 'Content-Type: application/json' -d \
             @api/examples/two_cylinders.json\n"
        )
    } else {
        let hint = "The service is stopped. `brinell serve` runs it; on a terminal, so does \
                    `brinell demo`.";
        format!("\nThe service listened on {url}. {hint}\n")
    }
}

fn say(text: &str) -> Result<(), Fault> {
    write_answer(None, text.as_bytes())
}
