//! Verification against closed forms and independent conditions, one file for each named problem.

mod contact_solvers;
