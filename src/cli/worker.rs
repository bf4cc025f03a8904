//! `brinell worker`

use std::process::ExitCode;
use std::sync::Arc;

use super::common::block_on;
use super::fault::Fault;
use crate::app::run_worker;
use crate::config::WorkerConfig;
use crate::jobs::CoreSolver;
use crate::lifecycle::stop_on_signal;

pub(super) fn worker(config: &WorkerConfig) -> Result<ExitCode, Fault> {
    block_on(async {
        let stop = stop_on_signal()?;
        run_worker(config, Arc::new(CoreSolver::with_cache(config.work.factor_cache())), stop)
            .await?;
        Ok(ExitCode::SUCCESS)
    })
}
