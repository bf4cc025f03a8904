//! Statements that go to the database in one message and are one transaction.
//!
//! The database ends the transaction by itself: a process that stops meanwhile holds nothing, and
//! a slow line is waited for once. A message has no parameters: values are written into its text,
//! as numbers and as hexadecimal digits. Of the text of a client nothing but letters and digits
//! stands in it as it is.

use std::fmt::Write as _;

use futures_util::TryStreamExt;
use sqlx::postgres::PgRow;
use sqlx::sqlite::SqliteRow;
use sqlx::types::Uuid;
use sqlx::{AssertSqlSafe, Either, FromRow, PgConnection, Postgres, Sqlite, SqliteConnection};

use crate::jobs::{JobId, Lease, StoreError};

/// A value in a statement.
#[derive(Debug, Clone, Copy)]
pub(super) enum Value<'a> {
    Flag(bool),
    Number(Option<i64>),
    Id(Uuid),
    Text(Option<&'a str>),
    Bytes(&'a [u8]),
    /// A time, or that of the database's clock.
    Time(Option<i64>),
    /// A list of jobs, in parentheses.
    Jobs(&'a [JobId]),
}

impl Value<'_> {
    /// A number, or the largest one that the database has.
    pub(super) fn number(number: impl TryInto<i64>) -> Self {
        Self::Number(Some(number.try_into().unwrap_or(i64::MAX)))
    }
}

/// How a database writes what the other writes differently.
pub(in crate::store) struct Dialect {
    begin: &'static str,
    commit: &'static str,
    /// Before and behind the hexadecimal digits of an id and of bytes.
    id: [&'static str; 2],
    bytes: [&'static str; 2],
    /// Writes the text of a client as a constant, which an index is searched by.
    text: fn(&mut String, &str),
    clock: &'static str,
    /// Locks the row of a job against all others.
    pub(super) lock: &'static str,
    /// The same, and passes over a row that another transaction has locked.
    pub(super) lock_free: &'static str,
    /// Locks the row of a job against other changes, and passes over it as above.
    pub(super) lock_change: &'static str,
    /// Locks the row of a job against a takeover, not against its heartbeat.
    pub(super) share: &'static str,
    /// Excludes other claims until the end of the message.
    pub(super) one_claim: &'static str,
    /// Excludes other submissions until the end of the transaction.
    pub(super) one_intake: &'static str,
}

/// SQLite has one writer, which needs no locks, and its clock is that of the process.
const SQLITE: Dialect = Dialect {
    begin: "BEGIN IMMEDIATE;",
    commit: "COMMIT",
    id: ["X'", "'"],
    bytes: ["X'", "'"],
    text: |message, client| {
        write_hex(message, ["CAST(X'", "' AS TEXT)"], client.as_bytes());
    },
    clock: "0",
    lock: "",
    lock_free: "",
    lock_change: "",
    share: "",
    one_claim: "SELECT 1",
    one_intake: "SELECT 1",
};

/// PostgreSQL makes one transaction of a message.
const POSTGRES: Dialect = Dialect {
    begin: "",
    commit: "",
    id: ["'", "'::uuid"],
    bytes: ["'\\x", "'::bytea"],
    text: |message, client| {
        message.push_str("U&'");
        for character in client.chars() {
            if character.is_ascii_alphanumeric() {
                message.push(character);
            } else {
                let _ = write!(message, "\\+{:06x}", u32::from(character));
            }
        }
        message.push_str("'::text");
    },
    clock: "(extract(epoch FROM statement_timestamp()) * 1000000)::bigint",
    lock: " FOR UPDATE",
    lock_free: " FOR UPDATE SKIP LOCKED",
    lock_change: " FOR NO KEY UPDATE SKIP LOCKED",
    share: " FOR KEY SHARE",
    // No other locks have these numbers.
    one_claim: "SELECT pg_advisory_xact_lock(4242002)",
    one_intake: "SELECT pg_advisory_xact_lock(4242001)",
};

/// Writes bytes as hexadecimal digits.
fn write_hex(text: &mut String, [before, behind]: [&str; 2], bytes: &[u8]) {
    text.push_str(before);
    for byte in bytes {
        let _ = write!(text, "{byte:02x}");
    }
    text.push_str(behind);
}

impl Dialect {
    fn write(&self, text: &mut String, value: Value<'_>) {
        match value {
            Value::Flag(flag) => text.push_str(if flag { "TRUE" } else { "FALSE" }),
            Value::Number(None) | Value::Text(None) => text.push_str("NULL"),
            Value::Number(Some(number)) | Value::Time(Some(number)) => {
                let _ = write!(text, "CAST({number} AS BIGINT)");
            }
            Value::Time(None) => text.push_str(self.clock),
            Value::Id(id) => write_hex(text, self.id, id.as_bytes()),
            Value::Bytes(bytes) => write_hex(text, self.bytes, bytes),
            Value::Text(Some(client)) => (self.text)(text, client),
            Value::Jobs(jobs) => {
                // No job has this id; an empty list would be an error.
                text.push('(');
                write_hex(text, self.id, Uuid::nil().as_bytes());
                for job in jobs {
                    text.push(',');
                    write_hex(text, self.id, job.uuid().as_bytes());
                }
                text.push(')');
            }
        }
    }
}

/// A message to a database.
pub(in crate::store) struct Message {
    dialect: &'static Dialect,
    text: String,
    statements: usize,
    /// Whether it is a transaction of its own.
    is_whole: bool,
}

impl Message {
    /// Appends a statement with `values` for its parameters `$1`, `$2` and so on.
    pub(super) fn push(&mut self, statement: &str, values: &[Value<'_>]) {
        let mut parts = statement.split('$');
        self.text.push_str(parts.next().unwrap_or_default());
        for part in parts {
            let digits = part.bytes().take_while(u8::is_ascii_digit).count();
            let (number, rest) = part.split_at(digits);
            let place = number.parse::<usize>().ok().and_then(|number| number.checked_sub(1));
            if let Some(value) = place.and_then(|place| values.get(place)) {
                self.dialect.write(&mut self.text, *value);
            }
            self.text.push_str(rest);
        }
        self.text.push(';');
        self.statements += 1;
    }

    /// The number of statements.
    pub(super) fn len(&self) -> usize {
        self.statements
    }
}

/// Columns that a row of either database is read as.
pub(in crate::store) trait Columns:
    for<'r> FromRow<'r, SqliteRow> + for<'r> FromRow<'r, PgRow>
{
}

impl<T: for<'r> FromRow<'r, SqliteRow> + for<'r> FromRow<'r, PgRow>> Columns for T {}

/// A connection that takes messages.
pub(in crate::store) trait Messages: Send {
    /// A row of an answer.
    type Row: Send + 'static;
    /// What the database writes in its own way.
    const DIALECT: &'static Dialect;
    /// Sends a message; returns the rows of each of its statements.
    fn send(
        &mut self,
        message: Message,
    ) -> impl Future<Output = Result<Vec<Vec<Self::Row>>, StoreError>> + Send;
    /// Inserts `bytes` for the holder of a lease by a statement whose parameters are job, owner,
    /// attempt, the `numbers` and the bytes; returns the number of rows. The bytes travel as they
    /// are.
    fn insert(
        &mut self,
        statement: &str,
        lease: &Lease,
        numbers: &[i64],
        bytes: &[u8],
    ) -> impl Future<Output = Result<u64, StoreError>> + Send;
    /// Reads the columns of a row.
    fn columns<T: Columns>(row: &Self::Row) -> Result<T, StoreError>;
    /// Begins a message.
    fn message() -> Message {
        let (dialect, text) = (Self::DIALECT, Self::DIALECT.begin.to_owned());
        Message { dialect, text, statements: 0, is_whole: true }
    }
    /// Begins a message that is a part of a transaction.
    fn part() -> Message {
        Message { text: String::new(), is_whole: false, ..Self::message() }
    }
}

macro_rules! messages {
    ($database:ty, $connection:ty, $row:ty, $dialect:ident) => {
        impl Messages for $connection {
            type Row = $row;
            const DIALECT: &'static Dialect = &$dialect;

            async fn send(&mut self, message: Message) -> Result<Vec<Vec<$row>>, StoreError> {
                if message.statements == 0 {
                    return Ok(Vec::new());
                }
                let has_begin = message.is_whole && !message.dialect.begin.is_empty();
                let commit = if has_begin { message.dialect.commit } else { "" };
                let text = message.text + commit;
                let mut answers = vec![Vec::new()];
                let mut stream = sqlx::raw_sql(AssertSqlSafe(text)).fetch_many(&mut *self);
                while let Some(answer) = stream.try_next().await? {
                    match answer {
                        Either::Left(_) => answers.push(Vec::new()),
                        Either::Right(row) => answers.last_mut().map_or((), |rows| rows.push(row)),
                    }
                }
                Ok(answers.split_off(usize::from(has_begin).min(answers.len())))
            }

            async fn insert(
                &mut self,
                statement: &str,
                lease: &Lease,
                numbers: &[i64],
                bytes: &[u8],
            ) -> Result<u64, StoreError> {
                let insert = sqlx::query::<$database>(AssertSqlSafe(statement.to_owned()));
                let insert = insert.bind(lease.job.uuid()).bind(lease.owner.uuid());
                let insert = insert.bind(i64::from(lease.attempt));
                let insert = numbers.iter().fold(insert, |insert, number| insert.bind(*number));
                Ok(insert.bind(bytes).execute(self).await?.rows_affected())
            }

            fn columns<T: Columns>(row: &$row) -> Result<T, StoreError> {
                Ok(T::from_row(row)?)
            }
        }
    };
}

messages!(Sqlite, SqliteConnection, SqliteRow, SQLITE);
messages!(Postgres, PgConnection, PgRow, POSTGRES);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_of_clients_end_no_literal() {
        let client = "a'; DROP TABLE jobs; --\\é$1";
        let written = |dialect: &'static Dialect| {
            let mut message =
                Message { dialect, text: String::new(), statements: 0, is_whole: false };
            message.push("SELECT $1", &[Value::Text(Some(client))]);
            message.text
        };
        for (dialect, begin, end) in
            [(&SQLITE, "SELECT CAST(X'", "' AS TEXT);"), (&POSTGRES, "SELECT U&'", "'::text;")]
        {
            let message = written(dialect);
            let literal = message.strip_prefix(begin).unwrap().strip_suffix(end).unwrap();
            assert!(!literal.contains(['\'', ';', '$', ' ', '"']), "{message}");
        }
    }
}
