//! The service inside the test's process, so that its solver can be chosen.

use std::num::NonZeroUsize;
use std::sync::Arc;

use brinell::app::{AppError, Service};
use brinell::config::ServeConfig;
use serde_json::{Value, json};
use tokio::runtime::Runtime;
use tokio::task::JoinHandle;
use tokio::time::timeout;
use tokio_util::sync::CancellationToken;

use crate::server::{DEADLINE, Target, example};
use crate::solvers::TestSolver;

pub struct InProcess {
    pub target: Target,
    pub solver: Arc<TestSolver>,
    pub stop: CancellationToken,
    server: JoinHandle<Result<(), AppError>>,
    runtime: Runtime,
}

impl InProcess {
    /// One solver slot, and whatever else `adjust` sets.
    pub fn start(adjust: impl FnOnce(&mut ServeConfig)) -> Self {
        let mut config =
            ServeConfig { listen: "127.0.0.1:0".to_owned(), ..ServeConfig::default() };
        config.work.workers = NonZeroUsize::new(1);
        config.storage.data_dir = ":memory:".into();
        adjust(&mut config);
        let runtime = Runtime::new().unwrap();
        let solver = Arc::new(TestSolver::default());
        let service = runtime.block_on(Service::bind(&config, Arc::clone(&solver) as _)).unwrap();
        let target = Target { url: format!("http://{}", service.address()) };
        let stop = CancellationToken::new();
        let server = runtime.spawn(service.run(stop.clone()));
        Self { target, solver, stop, server, runtime }
    }

    /// Waits for the service to end by itself.
    #[track_caller]
    pub fn wait(self) {
        let ended = self.runtime.block_on(async { timeout(DEADLINE, self.server).await });
        ended.expect("the service ends").unwrap().unwrap();
    }
}

/// The example, marked for [`TestSolver`].
pub fn job(behaviour: &str) -> Value {
    let mut job = example();
    job["tags"] = json!({"test": behaviour});
    job
}
