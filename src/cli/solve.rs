//! `brinell solve`

use std::io::{self, IsTerminal};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Args, ValueEnum};

use super::array::{ArrayArgs, solve_array};
use super::common::NOT_CONVERGED;
use super::fault::Fault;
use super::input::{Output, Settings};
use super::progress::ProgressLine;
use super::style::Style;
use super::table::table;
use crate::jobs::encode;
use brinell_solver::job::JobError;
use brinell_solver::report::export::{Export, ExportError};
use brinell_solver::report::{self, RunError};
use brinell_solver::solver::SolveStatus;

/// Arguments of `brinell solve`.
#[derive(Debug, Args)]
pub(super) struct SolveArgs {
    /// The job (JSON); - is standard input
    #[arg(value_name = "FILE", required_unless_present = "array", conflicts_with = "array")]
    job: Option<PathBuf>,

    #[command(flatten)]
    settings: Settings,

    /// How to print the result [default: that of the ending of --output, else table on a
    /// terminal, json elsewhere]
    #[arg(long, value_enum)]
    format: Option<ResultFormat>,

    /// Which step of a sweep table, vtu, vtr, svg, depth-svg and surface-svg show, counted from 1
    /// [default: the last; table: all in short]
    #[arg(long, value_name = "N")]
    step: Option<NonZeroUsize>,

    /// Where to write the result [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    #[command(flatten)]
    array: ArrayArgs,
}

impl SolveArgs {
    fn format(&self) -> ResultFormat {
        let for_a_person = self.output.is_none() && io::stdout().is_terminal();
        let usual = if for_a_person { ResultFormat::Table } else { ResultFormat::Json };
        let of_ending = || {
            let ending = self.output.as_ref()?.extension()?.to_str()?;
            ResultFormat::from_str(ending, true).ok()
        };
        self.format.or_else(of_ending).unwrap_or(usual)
    }

    fn style(&self) -> Style {
        if self.output.is_none() { Style::of_stdout() } else { Style::PLAIN }
    }
}

/// How to print a result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum ResultFormat {
    /// JSON, for programs
    Json,
    /// A table, for people
    Table,
    /// One row of figures for each step
    SummaryCsv,
    /// Contact pressure of all steps
    Csv,
    /// Stresses over depth of all steps
    SubsurfaceCsv,
    /// Every increment of a history
    IncrementsCsv,
    /// Load-displacement curve of a hardness test
    HardnessCsv,
    /// Passes of a load that rolls
    PassesCsv,
    /// Utilization over depth by criteria of fatigue
    FatigueCsv,
    /// Surfaces of all steps, the dent among them
    SurfaceCsv,
    /// Mesh, displacements and stresses, for ParaView
    Vtu,
    /// Stress and plastic strain in layers, in three dimensions, for ParaView
    Vtr,
    /// Contact pressure, drawn
    Svg,
    /// Stresses over depth, drawn
    DepthSvg,
    /// Force over approach, drawn
    LoadApproachSvg,
    /// Surfaces: the dent and its pile-up, drawn
    SurfaceSvg,
}

impl ResultFormat {
    /// The form of the report that this is, if it is one for other programs.
    fn export(self) -> Option<Export> {
        match self {
            Self::Json | Self::Table => None,
            Self::SummaryCsv => Some(Export::SummaryCsv),
            Self::Csv => Some(Export::PressureCsv),
            Self::SubsurfaceCsv => Some(Export::SubsurfaceCsv),
            Self::IncrementsCsv => Some(Export::IncrementsCsv),
            Self::HardnessCsv => Some(Export::HardnessCsv),
            Self::PassesCsv => Some(Export::PassesCsv),
            Self::FatigueCsv => Some(Export::FatigueCsv),
            Self::SurfaceCsv => Some(Export::SurfaceCsv),
            Self::Vtu => Some(Export::FieldVtu),
            Self::Vtr => Some(Export::FieldVtr),
            Self::Svg => Some(Export::PressureSvg),
            Self::DepthSvg => Some(Export::DepthSvg),
            Self::LoadApproachSvg => Some(Export::LoadApproachSvg),
            Self::SurfaceSvg => Some(Export::SurfaceSvg),
        }
    }
}

pub(super) fn solve(args: &SolveArgs) -> Result<ExitCode, Fault> {
    if let Some(jobs) = &args.array.array {
        return solve_array(jobs, &args.array);
    }
    let (name, mut job) = args.settings.read_job(args.job.as_deref().unwrap_or(Path::new("-")))?;
    let format = args.format();
    if let Some(form) = format.export() {
        form.require(&mut job);
    }
    // What is not solved is refused before anything is.
    report::preflight(&job).map_err(|errors| Fault::of_job(&name, JobError::Fields(errors)))?;
    let output = Output::open(args.output.as_deref(), args.job.as_deref())?;
    let mut progress = ProgressLine::start();
    let report = report::run(&job, &mut progress).map_err(|error| match error {
        RunError::Input(errors) => Fault::of_job(&name, JobError::Fields(errors)),
        other => Fault::Run(other),
    })?;
    drop(progress);
    let step = args.step.map(|step| step.get() - 1);
    let text = if let Some(form) = format.export() {
        encode(&report)?;
        form.write(&job, &report, step)?.into_bytes()
    } else if format == ResultFormat::Table {
        encode(&report)?;
        if let Some(missing) = step.filter(|step| *step >= report.steps.len()) {
            return Err(ExportError::NoStep(missing).into());
        }
        table(&job, &report, step, args.style()).into_bytes()
    } else {
        [encode(&report)?.as_ref(), b"\n"].concat()
    };
    output.write(&text)?;
    Ok(match report.status {
        SolveStatus::Converged => ExitCode::SUCCESS,
        _ => ExitCode::from(NOT_CONVERGED),
    })
}
