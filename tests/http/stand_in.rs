//! What stands in for `curl` on a machine without it: as much of it as these tests use, without TLS.
//!
//! It is a process of its own, for tests follow, outlive and kill their clients.

use std::io::{self, Read, Write};
use std::process::Command;
use std::time::Duration;

use bytes::Bytes;
use flate2::read::GzDecoder;
use http_body_util::{BodyExt, Full};
use hyper::client::conn::http1;
use hyper::{Request, Uri};
use hyper_util::rt::TokioIo;
use tokio::net::TcpStream;

/// The variable that tells the arguments. What runs the tests would take them for its own.
const ARGUMENTS: &str = "BRINELL_TEST_CURL";

/// This program, as what is called like `curl`.
pub fn command(args: &[&str]) -> Command {
    let mut command = Command::new(std::env::current_exe().expect("a test program"));
    command.args(["--ignored", "--exact", "--nocapture", "stand_in::is_called"]);
    command.env(ARGUMENTS, serde_json::to_string(args).expect("texts"));
    command
}

#[test]
#[ignore = "stands in for curl"]
fn is_called() {
    let Ok(args) = std::env::var(ARGUMENTS) else { return };
    let args: Vec<String> = serde_json::from_str(&args).unwrap();
    let (call, patience, compressed) = read(&args);
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
    let answered =
        runtime.block_on(async { tokio::time::timeout(patience, ask(call, compressed)).await });
    let code = match answered {
        Ok(Ok(())) => 0,
        Ok(Err(error)) => {
            eprintln!("{error}");
            7
        }
        Err(_) => 28,
    };
    // What runs the tests would write its summary behind the answer.
    std::process::exit(code);
}

/// The request, how long to wait and whether to decompress.
fn read(args: &[String]) -> (Request<Full<Bytes>>, Duration, bool) {
    let mut args = args.iter().map(String::as_str);
    let (mut method, mut address, mut headers, mut body) = (None, "", Vec::new(), None);
    let (mut patience, mut compressed) = (Duration::MAX, false);
    while let Some(arg) = args.next() {
        let mut value = || args.next().expect("a value");
        match arg {
            "-X" => method = Some(value()),
            "-H" => headers.extend(value().split_once(':')),
            "-d" | "--data-binary" => body = Some(data(value())),
            "--max-time" => patience = Duration::from_secs_f64(value().parse().unwrap()),
            "--noproxy" => drop(value()),
            "--compressed" => compressed = true,
            "--silent" | "--show-error" | "--include" | "--no-buffer" | "--path-as-is" => {}
            _ => {
                assert!(!arg.starts_with('-'), "the stand-in for curl does not know {arg}");
                address = arg;
            }
        }
    }
    let uri: Uri = address.parse().expect("an address");
    let mut defaults = vec![("host", uri.authority().unwrap().as_str()), ("accept", "*/*")];
    if body.is_some() {
        defaults.push(("content-type", "application/x-www-form-urlencoded"));
    }
    if compressed {
        defaults.push(("accept-encoding", "gzip"));
    }
    let given = |name: &str| headers.iter().any(|(key, _)| key.eq_ignore_ascii_case(name));
    defaults.retain(|(name, _)| !given(name));
    let usual = if body.is_some() { "POST" } else { "GET" };
    let mut request = Request::builder().method(method.unwrap_or(usual)).uri(&uri);
    for (name, value) in defaults.into_iter().chain(headers).filter(|(_, value)| !value.is_empty())
    {
        request = request.header(name, value.trim().as_bytes());
    }
    (request.body(body.unwrap_or_default().into()).unwrap(), patience, compressed)
}

/// What is posted: the text itself, or standard input.
fn data(text: &str) -> Vec<u8> {
    let mut read = text.as_bytes().to_vec();
    if text == "@-" {
        read.clear();
        io::stdin().read_to_end(&mut read).unwrap();
    }
    read
}

/// Sends it, and prints head and body as they come.
async fn ask(
    mut call: Request<Full<Bytes>>,
    compressed: bool,
) -> Result<(), Box<dyn std::error::Error>> {
    let stream = TcpStream::connect(call.uri().authority().unwrap().as_str()).await?;
    let path = call.uri().path_and_query().unwrap().as_str().parse()?;
    *call.uri_mut() = path;
    let (mut sender, connection) = http1::handshake(TokioIo::new(stream)).await?;
    tokio::spawn(connection);
    let mut answer = sender.send_request(call).await?;
    let mut out = io::stdout().lock();
    write!(out, "HTTP/1.1 {}\r\n", answer.status())?;
    for (name, value) in answer.headers() {
        out.write_all(&[name.as_str().as_bytes(), b": ", value.as_bytes(), b"\r\n"].concat())?;
    }
    out.write_all(b"\r\n")?;
    if compressed
        && answer.headers().get("content-encoding").is_some_and(|coding| coding == "gzip")
    {
        let body = answer.collect().await?.to_bytes();
        io::copy(&mut GzDecoder::new(&body[..]), &mut out)?;
    } else {
        while let Some(frame) = answer.frame().await {
            out.write_all(frame?.data_ref().map_or(&[], |data| data))?;
            out.flush()?;
        }
    }
    out.flush()?;
    Ok(())
}
