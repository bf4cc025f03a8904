//! Threads that solve.

use std::io;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

/// Elimination trees are walked recursively in places; a solve has room for it.
const STACK_BYTES: usize = 8 << 20;

/// Scheduling priority (nice value) of threads whose jobs give way: others beside them get six parts in seven of a core.
#[cfg(target_os = "linux")]
const LONG_PRIORITY: i32 = 8;

type Task = Box<dyn FnOnce() + Send>;

/// A fixed number of threads for tasks, and as many for tasks that give way to them. They end when the pool is dropped and their
/// current task is done.
pub(super) struct SolverPool {
    tasks: Sender<Task>,
    giving_way: Sender<Task>,
}

impl SolverPool {
    /// Threads for as many tasks of either kind at the same time.
    pub(super) fn new(n_tasks: usize) -> io::Result<Self> {
        let tasks = start("solver", n_tasks, || ())?;
        let giving_way = start("long-solver", n_tasks, give_way)?;
        Ok(Self { tasks, giving_way })
    }

    /// Queues a task. Tasks must not panic.
    pub(super) fn run(&self, gives_way: bool, task: impl FnOnce() + Send + 'static) {
        // The threads live as long as the senders do; a task that nobody takes is dropped, and whoever waits
        // for its answer sees its channel close.
        let _ = if gives_way { &self.giving_way } else { &self.tasks }.send(Box::new(task));
    }
}

fn start(name: &str, n_threads: usize, prepare: fn()) -> io::Result<Sender<Task>> {
    let (tasks, receiver) = channel();
    let receiver = Arc::new(Mutex::new(receiver));
    for number in 0..n_threads {
        let receiver = Arc::clone(&receiver);
        thread::Builder::new().name(format!("{name}-{number}")).stack_size(STACK_BYTES).spawn(move || {
            prepare();
            work(&receiver);
        })?;
    }
    Ok(tasks)
}

/// Lowers the priority of this thread. Linux knows priorities of threads; elsewhere it would be that of the process.
fn give_way() {
    #[cfg(target_os = "linux")]
    if let Err(error) = rustix::process::setpriority_process(None, LONG_PRIORITY) {
        tracing::debug!(%error, "jobs that give way have the priority of others");
    }
}

fn work(tasks: &Mutex<Receiver<Task>>) {
    loop {
        let next = tasks.lock().unwrap_or_else(PoisonError::into_inner).recv();
        match next {
            Ok(task) => task(),
            Err(_) => return,
        }
    }
}
