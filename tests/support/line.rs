//! A line between a process and PostgreSQL that has faults: it is slow, silent, or late.

use std::io::{Read, Write};
use std::net::{Ipv4Addr, Shutdown, TcpListener, TcpStream};
use std::os::unix::net::UnixStream;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use sqlx::postgres::PgConnectOptions;

/// The line. Each connection through it has the faults for itself.
pub struct Line {
    /// The address of the database behind it.
    pub url: String,
    faults: Arc<Faults>,
}

#[derive(Default)]
struct Faults {
    /// Bytes a second to the database; 0 is no bound.
    rate: AtomicU64,
    /// Milliseconds by which each answer is late.
    late: AtomicU64,
    /// When silences begin, how many there are, and how long each is: nothing passes, and nothing
    /// is closed.
    silences: Mutex<Option<(Instant, u32, Duration)>>,
}

/// Two ends of a connection to the database.
trait End: Read + Write + Send + Sized + 'static {
    fn again(&self) -> Self;
    fn close(&self);
}

macro_rules! end {
    ($stream:ty) => {
        impl End for $stream {
            fn again(&self) -> Self {
                self.try_clone().unwrap()
            }

            fn close(&self) {
                let _ = self.shutdown(Shutdown::Both);
            }
        }
    };
}

end!(TcpStream);
end!(UnixStream);

impl Line {
    /// A line without faults to the database at an address.
    pub fn to(database: &str) -> Self {
        let options: PgConnectOptions = database.parse().unwrap();
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).unwrap();
        let port = listener.local_addr().unwrap().port();
        let (user, name) = (options.get_username(), options.get_database().unwrap());
        let url = format!("postgres://{user}@127.0.0.1:{port}/{name}");
        let faults = Arc::<Faults>::default();
        let of_line = Arc::clone(&faults);
        thread::spawn(move || {
            for client in listener.incoming().flatten() {
                if let Some(directory) = options.get_socket() {
                    let socket = directory.join(format!(".s.PGSQL.{}", options.get_port()));
                    join(client, UnixStream::connect(socket).unwrap(), &of_line);
                } else {
                    let server = (options.get_host(), options.get_port());
                    join(client, TcpStream::connect(server).unwrap(), &of_line);
                }
            }
        });
        Self { url, faults }
    }

    pub fn set_rate(&self, bytes_a_second: u64) {
        self.faults.rate.store(bytes_a_second, Ordering::Relaxed);
    }

    pub fn set_late(&self, by: Duration) {
        let milliseconds = u64::try_from(by.as_millis()).unwrap();
        self.faults.late.store(milliseconds, Ordering::Relaxed);
    }

    /// Lets the line fall silent again and again, with a breath in between.
    pub fn fall_silent(&self, times: u32, length: Duration) {
        *self.faults.silences.lock().unwrap() = Some((Instant::now(), times, length));
    }
}

impl Faults {
    /// What is left of a silence.
    fn silence(&self) -> Duration {
        let Some((since, times, length)) = *self.silences.lock().unwrap() else {
            return Duration::ZERO;
        };
        let round = length + length / 20;
        let past = since.elapsed();
        let into = past.as_nanos() % round.as_nanos();
        let left = length.as_nanos().saturating_sub(into);
        let left = if past < times * round { left } else { 0 };
        Duration::from_nanos(left.try_into().unwrap())
    }
}

fn join(client: TcpStream, server: impl End, faults: &Arc<Faults>) {
    let _ = client.set_nodelay(true);
    let (up, down) = ((client.again(), server.again()), (server, client));
    let of_line = Arc::clone(faults);
    thread::spawn(move || {
        pass(up.0, up.1, &of_line, |length, faults| match faults.rate.load(Ordering::Relaxed) {
            0 => Duration::ZERO,
            rate => Duration::from_secs_f64(length as f64 / rate as f64),
        });
    });
    let of_line = Arc::clone(faults);
    thread::spawn(move || {
        pass(down.0, down.1, &of_line, |_, faults| {
            Duration::from_millis(faults.late.load(Ordering::Relaxed))
        });
    });
}

/// Passes bytes on until an end closes.
fn pass(
    mut from: impl End,
    mut to: impl End,
    faults: &Faults,
    delay: impl Fn(usize, &Faults) -> Duration,
) {
    let mut bytes = vec![0; 1 << 16];
    while let Ok(length @ 1..) = from.read(&mut bytes) {
        // A line with faults is one that waits.
        thread::sleep(delay(length, faults));
        thread::sleep(faults.silence());
        if to.write_all(&bytes[..length]).is_err() {
            break;
        }
    }
    from.close();
    to.close();
}
