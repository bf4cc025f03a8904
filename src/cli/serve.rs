//! `brinell serve`

use std::process::ExitCode;
use std::sync::Arc;

use super::common::block_on;
use super::fault::Fault;
use super::input::write_answer;
use crate::app::Service;
use crate::config::ServeConfig;
use crate::jobs::CoreSolver;
use crate::lifecycle::{stop_on_signal, stop_with_stdin};

pub(super) fn serve(config: &ServeConfig) -> Result<ExitCode, Fault> {
    block_on(async {
        let stop = stop_on_signal()?;
        if config.exit_with_stdin {
            stop_with_stdin(stop.clone())?;
        }
        let service =
            Service::bind(config, Arc::new(CoreSolver::with_cache(config.work.factor_cache())))
                .await?;
        // The one line on standard output, for scripts that let the system choose the port.
        write_answer(None, format!("brinell listening on {}\n", service.url()).as_bytes())?;
        service.run(stop).await?;
        Ok(ExitCode::SUCCESS)
    })
}
