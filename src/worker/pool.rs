//! Threads that solve.

use std::io;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

/// Elimination trees are walked recursively in places; a solve has room for it.
const STACK_BYTES: usize = 8 << 20;

/// Scheduling priority (nice value) of threads with long jobs: short ones beside them get three parts in four of a core.
#[cfg(target_os = "linux")]
const LONG_PRIORITY: i32 = 5;

type Task = Box<dyn FnOnce() + Send>;

/// A fixed number of threads for short and for long tasks, which give way to the short ones. They end when the pool is dropped and
/// their current task is done.
pub(super) struct SolverPool {
    short: Sender<Task>,
    long: Sender<Task>,
}

impl SolverPool {
    /// Threads for as many short and long tasks at the same time.
    pub(super) fn new(n_short: usize, n_long: usize) -> io::Result<Self> {
        let short = start("solver", n_short, || ())?;
        let long = start("long-solver", n_long, give_way)?;
        Ok(Self { short, long })
    }

    /// Queues a task. Tasks must not panic.
    pub(super) fn run(&self, long: bool, task: impl FnOnce() + Send + 'static) {
        // The threads live as long as the senders do; a task that nobody takes is dropped, and whoever waits
        // for its answer sees its channel close.
        let _ = if long { &self.long } else { &self.short }.send(Box::new(task));
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
        tracing::debug!(%error, "long jobs have the priority of short ones");
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
