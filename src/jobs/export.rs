//! Export of stored results in formats of other programs. Tables and field files are written piece
//! by piece at the speed of the client; pictures are small and written at once.

use std::iter::once;
use std::ops::Range;
use std::sync::Arc;

use bytes::Bytes;
use thiserror::Error;
use tokio::sync::mpsc::Sender;

use super::{FieldsReader, JobId, JobService, JobStore, KeyId, StoreError};
use brinell_solver::job::Job;
use brinell_solver::report::export::{
    Export, ExportError, Table, VtkContents, VtkFile, VtrFile, VtuFile, surface_vtu,
};
use brinell_solver::report::{Report, StepReport};

/// Smallest size \[bytes\] of a chunk, except the last.
const PIECE: usize = 64 << 10;
/// Most arrays of fields that are read at once.
const ARRAYS: usize = 6;

/// An error of an export.
#[derive(Debug, Error)]
pub enum ExportFailure {
    /// The store has no such job, does not answer, or is damaged.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// The job has no result, or none yet.
    #[error("the job has no result")]
    NoResult,
    /// The result cannot be written in this format.
    #[error(transparent)]
    Export(#[from] ExportError),
}

/// A result in an export format, as it is sent.
pub struct Exported {
    jobs: Arc<JobService>,
    id: JobId,
    key: Option<KeyId>,
    form: ExportForm,
}

type Fields = FieldsReader<Arc<dyn JobStore>>;
type Pieces = Box<dyn Iterator<Item = String> + Send>;

enum ExportForm {
    Pieces(Pieces),
    Table(Table, Range<usize>),
    Mesh(VtuFile, Fields),
    Layers(VtrFile, Fields),
}

impl JobService {
    /// Exports the report of a job. `step` is counted from 0; without it, a table has all steps
    /// and any other format the last step.
    ///
    /// # Errors
    /// [`ExportFailure`].
    pub async fn export(
        self: &Arc<Self>,
        id: JobId,
        form: Export,
        step: Option<usize>,
        key: Option<KeyId>,
    ) -> Result<Exported, ExportFailure> {
        let head = self.result(id).await?.ok_or(ExportFailure::NoResult)?;
        let request = self.store.request(id).await?;
        let steps = head.steps;
        let read = move || {
            let job = Job::from_json(&request).map_err(StoreError::damaged)?;
            let report: Report =
                serde_json::from_slice(&head.report).map_err(StoreError::damaged)?;
            Ok::<_, StoreError>((job, report))
        };
        let (job, mut report) = self.decoders.run(key, read).await?;
        let exported = |form| Exported { jobs: Arc::clone(self), id, key, form };
        let last = steps.checked_sub(1).ok_or(ExportError::NoStep(0))?;
        let wanted = step.unwrap_or(last);
        if wanted > last {
            return Err(ExportError::NoStep(wanted).into());
        }
        let shown = if form.is_table() { 0 } else { wanted };
        let mut shown = self.step_report(id, shown, key).await?;
        Ok(exported(if form.is_table() {
            let mut table = Table::new(form, &job, &shown)?;
            if form == Export::SummaryCsv {
                for number in 0..steps {
                    table.see(&self.step_report(id, number, key).await?);
                }
            }
            ExportForm::Table(table, step.map_or(0..steps, |step| step..step + 1))
        } else if form == Export::FieldVtu && shown.contact.section.is_some() {
            let maps = shown.contact.maps.take().ok_or(ExportError::NoFields)?;
            ExportForm::Pieces(Box::new(surface_vtu(&report, [wanted, steps], maps)))
        } else if form == Export::FieldVtu {
            let fields = self.fields(id, wanted).await?;
            // The layers of a load that rolls are no mesh.
            let fields = fields.filter(|fields| fields.layout().member() == "fields");
            let fields = fields.ok_or(ExportError::NoFields)?;
            ExportForm::Mesh(
                VtuFile::new(
                    &report,
                    [wanted, steps],
                    shown.approach().unwrap_or_default(),
                    fields.layout(),
                )?,
                fields,
            )
        } else if form == Export::FieldVtr {
            let fields = self.fields(id, wanted).await?.ok_or(ExportError::NoLayers)?;
            ExportForm::Layers(VtrFile::new(&report, [wanted, steps], fields.layout())?, fields)
        } else {
            report.steps.push(shown);
            let written = self.decoders.run(key, move || form.write(&job, &report, None)).await?;
            ExportForm::Pieces(Box::new(once(written)))
        }))
    }

    async fn step_report(
        &self,
        id: JobId,
        number: usize,
        key: Option<KeyId>,
    ) -> Result<StepReport, StoreError> {
        let text = self.store.step(id, number).await?;
        let read = move || {
            let text = text.text().map_err(StoreError::damaged)?;
            serde_json::from_slice(&text).map_err(StoreError::damaged)
        };
        self.decoders.run(key, read).await
    }
}

impl Exported {
    /// Sends the whole export; a client that hung up is no error.
    ///
    /// # Errors
    /// [`StoreError`].
    pub async fn send(self, sender: Sender<Bytes>) -> Result<(), StoreError> {
        let Self { jobs, id, key, form } = self;
        let mut out = Out { text: String::new(), sender };
        match form {
            ExportForm::Pieces(mut pieces) => {
                let next = |mut pieces: Pieces| move || (pieces.next(), pieces);
                while let (Some(piece), rest) = jobs.decoders.run(key, next(pieces)).await {
                    out.add(&piece).await;
                    pieces = rest;
                }
            }
            ExportForm::Table(table, steps) => {
                out.add(&table.header()).await;
                let table = Arc::new(table);
                for number in steps {
                    let table = Arc::clone(&table);
                    let step = jobs.step_report(id, number, key).await?;
                    let rows = move || table.rows(number + 1, &step);
                    out.add(&jobs.decoders.run(key, rows).await).await;
                }
            }
            ExportForm::Mesh(file, fields) => out.fields(&jobs, key, file, fields).await?,
            ExportForm::Layers(file, fields) => out.fields(&jobs, key, file, fields).await?,
        }
        out.end().await;
        Ok(())
    }
}

/// Gathers small pieces into chunks.
struct Out {
    text: String,
    sender: Sender<Bytes>,
}

impl Out {
    async fn add(&mut self, text: &str) {
        self.text.push_str(text);
        if self.text.len() >= PIECE {
            let _ = self.sender.send(std::mem::take(&mut self.text).into()).await;
        }
    }

    async fn fields<C: VtkContents + Send>(
        &mut self,
        jobs: &JobService,
        key: Option<KeyId>,
        mut file: VtkFile<C>,
        fields: Fields,
    ) -> Result<(), StoreError> {
        let pieces = file.pieces();
        let mut readers = vec![fields; ARRAYS];
        for piece in pieces {
            let mut sources = Vec::with_capacity(ARRAYS);
            for (reader, source) in readers.iter_mut().zip(piece.sources()) {
                sources.push(reader.bytes(source.clone()).await?);
            }
            let write = move || {
                let text = file.write(&piece, &sources);
                (file, text)
            };
            let text;
            (file, text) = jobs.decoders.run(key, write).await;
            self.add(&text).await;
        }
        Ok(())
    }

    async fn end(self) {
        let _ = self.sender.send(self.text.into()).await;
    }
}
