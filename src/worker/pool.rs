//! Threads that solve.

use std::io;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

/// Elimination trees are walked recursively in places; a solve has room for it.
const STACK_BYTES: usize = 8 << 20;

type Task = Box<dyn FnOnce() + Send>;

/// A fixed number of threads that take tasks from one queue. They end when the pool is dropped and their
/// current task is done.
pub(super) struct SolverPool {
    tasks: Sender<Task>,
}

impl SolverPool {
    pub(super) fn new(n_threads: usize) -> io::Result<Self> {
        let (tasks, receiver) = channel();
        let receiver = Arc::new(Mutex::new(receiver));
        for number in 0..n_threads {
            let receiver = Arc::clone(&receiver);
            thread::Builder::new()
                .name(format!("solver-{number}"))
                .stack_size(STACK_BYTES)
                .spawn(move || work(&receiver))?;
        }
        Ok(Self { tasks })
    }

    /// Queues a task. Tasks must not panic.
    pub(super) fn run(&self, task: impl FnOnce() + Send + 'static) {
        // The threads live as long as `self.tasks` does; a task that nobody takes is dropped, and whoever waits
        // for its answer sees its channel close.
        let _ = self.tasks.send(Box::new(task));
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
