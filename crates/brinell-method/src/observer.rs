//! The observer of a solve: it receives every iteration and may stop the solve.

use std::ops::ControlFlow;
use std::time::Duration;

use strum::{IntoStaticStr, VariantArray};

/// How a solve ended. Not converging is a status, not an error.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantArray)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[strum(serialize_all = "snake_case")]
pub enum SolveStatus {
    /// Displacement change and equilibrium residual are below the tolerance, and the final state
    /// passes the independent contact check.
    Converged,
    /// The iteration limit was reached or the final state fails a check; the last state is
    /// reported.
    NotConverged,
    /// The observer asked to stop.
    Cancelled,
    /// The observer's deadline passed.
    TimedOut,
}

/// Why an observer stops a solve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interrupt {
    /// The caller asked for it.
    Cancelled,
    /// The deadline passed.
    TimedOut,
}

impl SolveStatus {
    /// Whether the observer ended it.
    pub fn is_stopped(self) -> bool {
        self.interrupt().is_some()
    }

    /// Why the observer ended it, if it did.
    pub fn interrupt(self) -> Option<Interrupt> {
        match self {
            Self::Cancelled => Some(Interrupt::Cancelled),
            Self::TimedOut => Some(Interrupt::TimedOut),
            Self::Converged | Self::NotConverged => None,
        }
    }
}

impl From<Interrupt> for SolveStatus {
    fn from(interrupt: Interrupt) -> Self {
        match interrupt {
            Interrupt::Cancelled => Self::Cancelled,
            Interrupt::TimedOut => Self::TimedOut,
        }
    }
}

/// One outer iteration. Counts are of this iteration alone.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = Iteration))]
pub struct IterationRecord {
    /// One-based.
    pub iteration: usize,
    /// Simplex pivots, or active-set changes, of the contact solve.
    pub contact_pivots: usize,
    /// Initial-stress loads, or sets of secant moduli, put into effect.
    pub initial_stress_updates: usize,
    /// Stiffness factorizations.
    pub factorizations: usize,
    /// `‖u - u_previous‖ / ‖u‖`, the paper's criterion \[1 >= 0\].
    pub displacement_change: f64,
    /// `‖R - R_previous‖ / ‖R‖` \[1 >= 0\].
    pub force_change: f64,
    /// `‖∫Bᵀσ dV - R‖ / ‖R‖` over the free degrees of freedom \[1 >= 0\].
    pub equilibrium_residual: f64,
    /// Gauss points beyond yield, both bodies.
    pub plastic_points: usize,
    /// Pairs in contact.
    pub contact_pairs: usize,
    /// Approach α \[length\].
    pub approach: f64,
    /// Largest contact pressure \[stress >= 0\].
    pub peak_pressure: f64,
    /// Since the start of the job \[ms >= 0\].
    pub elapsed_ms: f64,
    /// The increment of a history to which the iteration belongs; absent where loads are not
    /// divided.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub increment: Option<IncrementNumber>,
}

/// Where a history of loads is. All numbers are one-based.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema), schema(as = IncrementNumber))]
pub struct IncrementNumber {
    /// Number of the increment within its load.
    pub number: usize,
    /// Increments of that load.
    pub count: usize,
    /// Number of the load.
    pub load: usize,
    /// Loads of the history.
    pub loads: usize,
}

impl IncrementNumber {
    /// Whether another increment of the same load follows.
    pub const fn is_on_way(self) -> bool {
        self.number < self.count
    }
}

/// Follows a solve, supplies its clock and may stop it. The solver itself has no clock and no
/// threads.
pub trait Observer {
    /// Called after every outer iteration.
    fn on_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        let _ = record;
        self.on_checkpoint()
    }

    /// Called after every outer iteration of a preliminary solve, which sizes meshes, increments
    /// or a force that is sought. The report does not list it.
    fn on_preliminary_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        let _ = record;
        self.on_checkpoint()
    }

    /// Called between phases and within the long ones, so that a stop does not wait for the next
    /// iteration.
    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        ControlFlow::Continue(())
    }

    /// Told how many bytes a part of the solve is about to hold, in place of what it held before.
    fn on_held(&mut self, part: Held, bytes: usize) -> ControlFlow<Interrupt> {
        let _ = (part, bytes);
        ControlFlow::Continue(())
    }

    /// Time since the job started; zero without a clock.
    fn elapsed(&self) -> Duration {
        Duration::ZERO
    }
}

/// Passes iterations on to another observer: with other figures, or as preliminary.
pub struct Retold<'a, F> {
    observer: &'a mut dyn Observer,
    is_preliminary: bool,
    record: F,
}

impl<'a, F: Fn(&IterationRecord) -> IterationRecord> Retold<'a, F> {
    /// Passes what `record` makes of an iteration on.
    pub fn new(observer: &'a mut dyn Observer, record: F) -> Self {
        Self { observer, is_preliminary: false, record }
    }

    /// As [`Self::new`], but every iteration is preliminary.
    pub fn preliminary(observer: &'a mut dyn Observer, record: F) -> Self {
        Self { observer, is_preliminary: true, record }
    }
}

impl<F: Fn(&IterationRecord) -> IterationRecord> Observer for Retold<'_, F> {
    fn on_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        if self.is_preliminary {
            return self.on_preliminary_iteration(record);
        }
        self.observer.on_iteration(&(self.record)(record))
    }

    fn on_preliminary_iteration(&mut self, record: &IterationRecord) -> ControlFlow<Interrupt> {
        self.observer.on_preliminary_iteration(&(self.record)(record))
    }

    fn on_checkpoint(&mut self) -> ControlFlow<Interrupt> {
        self.observer.on_checkpoint()
    }

    fn on_held(&mut self, part: Held, bytes: usize) -> ControlFlow<Interrupt> {
        self.observer.on_held(part, bytes)
    }

    fn elapsed(&self) -> Duration {
        self.observer.elapsed()
    }
}

/// A part of a solve that may take much memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Held {
    /// The bodies of a system and their factors.
    Bodies,
    /// The displacements at the ends of the increments of a history.
    Increments,
}

/// Asks the observer whether to stop.
///
/// # Errors
/// The interrupt that the observer returns.
pub fn ask(observer: &mut dyn Observer) -> Result<(), Interrupt> {
    observer.on_checkpoint().break_value().map_or(Ok(()), Err)
}

/// An observer that ignores every event and never stops a solve.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unobserved;

impl Observer for Unobserved {}
