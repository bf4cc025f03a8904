//! The HTTP client of the service: one POST over one connection to a checked address.
//!
//! The client resolves a name once, checks all its addresses and connects to one of them. A name
//! that resolves differently a moment later (DNS rebinding) therefore has no effect. The client
//! follows no redirects, uses no proxy and reads only the status of the answer.

mod address;

use std::io;
use std::net::{IpAddr, SocketAddr};
use std::path::Path;
use std::pin::pin;
use std::str::FromStr;
use std::sync::Arc;
use std::time::Duration;

use axum::http::{HeaderMap, Uri};
use bytes::Bytes;
use http_body_util::Full;
use hyper::client::conn::http1;
use hyper::header::HOST;
use hyper::{Method, Request, StatusCode};
use hyper_util::rt::TokioIo;
use rustls::pki_types::pem::PemObject;
use rustls::pki_types::{CertificateDer, ServerName};
use rustls::{ClientConfig, RootCertStore};
use thiserror::Error;
use tokio::io::{AsyncRead, AsyncWrite};
use tokio::net::{TcpStream, lookup_host};
use tokio::time::timeout;
use tokio_rustls::TlsConnector;

pub use address::is_public;

/// Most characters of a URL.
const MAX_URL: usize = 2000;

/// Longest time to connect to one of several addresses.
const CONNECT_TIMEOUT: Duration = Duration::from_secs(5);

/// Largest head \[bytes\] of an answer.
const HEAD_BYTES: usize = 16 << 10;

/// The target of a request.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Destination {
    /// Whether to use TLS.
    pub is_secure: bool,
    /// Name or address, in lower case; an IPv6 address without brackets.
    pub host: String,
    /// Port.
    pub port: u16,
    /// Path and query.
    pub path: String,
    /// Host and port as in the `Host` header.
    authority: String,
}

/// An error for a text that is no URL to send requests to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error(
    "must be https://host/path, or http://, of at most {MAX_URL} characters and without a user \
     name"
)]
pub struct NotADestination;

impl FromStr for Destination {
    type Err = NotADestination;

    fn from_str(text: &str) -> Result<Self, NotADestination> {
        let uri: Uri = text.parse().map_err(|_| NotADestination)?;
        let is_secure = match uri.scheme_str() {
            Some("https") => true,
            Some("http") => false,
            _ => return Err(NotADestination),
        };
        let authority = uri.authority().ok_or(NotADestination)?;
        let host = authority.host().to_ascii_lowercase();
        let host = host.strip_prefix('[').and_then(|host| host.strip_suffix(']')).unwrap_or(&host);
        let is_plain = !authority.as_str().contains('@') && !text.contains('#');
        let has_wrong_port =
            authority.port_u16().is_none() && authority.as_str() != authority.host();
        if host.is_empty() || text.len() > MAX_URL || !is_plain || has_wrong_port {
            return Err(NotADestination);
        }
        Ok(Self {
            is_secure,
            port: authority.port_u16().unwrap_or(if is_secure { 443 } else { 80 }),
            path: uri.path_and_query().map_or_else(|| "/".to_owned(), ToString::to_string),
            authority: authority.as_str().to_ascii_lowercase(),
            host: host.to_owned(),
        })
    }
}

impl Destination {
    /// Returns the URL of a path below this one.
    #[must_use]
    pub fn below(&self, path: &str) -> Self {
        Self { path: format!("{}{path}", self.path.trim_end_matches('/')), ..self.clone() }
    }

    /// Returns host and port as a socket address is written.
    pub fn listens(&self) -> String {
        let Self { host, port, .. } = self;
        if host.contains(':') { format!("[{host}]:{port}") } else { format!("{host}:{port}") }
    }

    /// Returns the URL as text.
    pub fn url(&self) -> String {
        let scheme = if self.is_secure { "https" } else { "http" };
        format!("{scheme}://{}{}", self.authority, self.path)
    }
}

/// An error of a request.
#[derive(Debug, Error)]
pub enum OutgoingError {
    /// The name has no address. The text equals that of [`Self::NotPublic`], so that a client
    /// cannot find out which names a private network resolves.
    #[error("the host has no address that may be called")]
    Resolve(#[source] io::Error),
    /// The host has an address that may not be called.
    #[error("the host has no address that may be called")]
    NotPublic,
    /// The connection failed.
    #[error("no connection: {0}")]
    Connect(#[source] io::Error),
    /// The TLS handshake failed.
    #[error("no secure connection: {0}")]
    Tls(#[source] io::Error),
    /// The answer is not HTTP.
    #[error("no answer: {0}")]
    Http(#[from] hyper::Error),
    /// The request cannot be written.
    #[error("no request: {0}")]
    Request(#[from] axum::http::Error),
}

/// An error of the file of certificates.
#[derive(Debug, Error)]
#[error("certificates of {path}: {reason}")]
pub struct RootsError {
    path: String,
    reason: String,
}

/// An HTTP client.
#[derive(Clone)]
pub struct Client {
    tls: TlsConnector,
    allow_private: bool,
}

impl Client {
    /// Makes a client that trusts the usual authorities and those of a file (PEM). `allow_private`
    /// permits addresses that are not public.
    ///
    /// # Errors
    /// [`RootsError`] where the file cannot be used.
    pub fn new(allow_private: bool, authorities: Option<&Path>) -> Result<Self, RootsError> {
        let mut roots = RootCertStore::empty();
        roots.extend(webpki_roots::TLS_SERVER_ROOTS.iter().cloned());
        if let Some(path) = authorities {
            let failed = |reason: String| RootsError { path: path.display().to_string(), reason };
            let certificates =
                CertificateDer::pem_file_iter(path).map_err(|error| failed(error.to_string()))?;
            for certificate in certificates {
                let certificate = certificate.map_err(|error| failed(error.to_string()))?;
                roots.add(certificate).map_err(|error| failed(error.to_string()))?;
            }
        }
        let config = ClientConfig::builder_with_provider(Arc::new(
            rustls::crypto::ring::default_provider(),
        ));
        let config = config.with_safe_default_protocol_versions();
        let config = config
            .map_err(|error| RootsError { path: "TLS".to_owned(), reason: error.to_string() })?;
        let config = config.with_root_certificates(roots).with_no_client_auth();
        Ok(Self { tls: TlsConnector::from(Arc::new(config)), allow_private })
    }

    /// POSTs a body and returns the status of the answer.
    ///
    /// # Errors
    /// [`OutgoingError`].
    pub async fn post(
        &self,
        to: &Destination,
        headers: HeaderMap,
        body: Bytes,
    ) -> Result<StatusCode, OutgoingError> {
        let mut request =
            Request::builder().method(Method::POST).uri(&to.path).header(HOST, &to.authority);
        if let Some(own) = request.headers_mut() {
            own.extend(headers);
        }
        let request = request.body(Full::new(body))?;
        let stream = self.connect(to).await?;
        if !to.is_secure {
            return exchange(stream, request).await;
        }
        let name = ServerName::try_from(to.host.clone())
            .map_err(|error| OutgoingError::Tls(io::Error::other(error)))?;
        exchange(self.tls.connect(name, stream).await.map_err(OutgoingError::Tls)?, request).await
    }

    /// Connects to one of the addresses of a host after checking all of them.
    async fn connect(&self, to: &Destination) -> Result<TcpStream, OutgoingError> {
        let found =
            lookup_host((to.host.as_str(), to.port)).await.map_err(OutgoingError::Resolve)?;
        let addresses: Vec<SocketAddr> = found.collect();
        if !addresses.iter().all(|address| self.may_ask(address.ip())) {
            return Err(OutgoingError::NotPublic);
        }
        let mut failed = io::Error::from(io::ErrorKind::NotFound);
        for address in addresses {
            match timeout(CONNECT_TIMEOUT, TcpStream::connect(address)).await {
                Ok(Ok(stream)) => return Ok(stream),
                Ok(Err(error)) => failed = error,
                Err(_) => failed = io::ErrorKind::TimedOut.into(),
            }
        }
        Err(OutgoingError::Connect(failed))
    }

    /// Returns whether an address may be called.
    pub fn may_ask(&self, address: IpAddr) -> bool {
        self.allow_private || is_public(address)
    }
}

/// Sends one request and returns the status of its answer.
async fn exchange(
    stream: impl AsyncRead + AsyncWrite + Unpin + Send + 'static,
    request: Request<Full<Bytes>>,
) -> Result<StatusCode, OutgoingError> {
    let mut builder = http1::Builder::new();
    builder.max_buf_size(HEAD_BYTES);
    let (mut sender, connection) = builder.handshake(TokioIo::new(stream)).await?;
    // Connection and answer are dropped here; the body is not read.
    let mut answer = pin!(sender.send_request(request));
    tokio::select! {
        response = &mut answer => return Ok(response?.status()),
        _ = connection => {}
    }
    // The receiver closed the connection, perhaps after its answer.
    Ok(answer.await?.status())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn destinations_are_addresses_of_the_web_and_nothing_else() {
        let read = |text: &str| text.parse::<Destination>();
        let plain = read("https://Hooks.example/press?x=1").unwrap();
        assert_eq!(
            (plain.host.as_str(), plain.port, plain.path.as_str()),
            ("hooks.example", 443, "/press?x=1")
        );
        let local = read("http://[::1]:8080").unwrap();
        assert_eq!((local.is_secure, local.host.as_str(), local.port), (false, "::1", 8080));
        assert_eq!(local.below("/v1/traces").url(), "http://[::1]:8080/v1/traces");
        assert_eq!((local.path.as_str(), local.authority.as_str()), ("/", "[::1]:8080"));
        for text in [
            "",
            "hooks.example",
            "/press",
            "ftp://hooks.example/",
            "file:///etc/passwd",
            "https://",
            "https:///press",
            "https://user@hooks.example/",
            "https://hooks.example:/",
            "https://hooks.example:99999/",
            "https://hooks.example/#part",
            "https://hooks.example/ x",
            "https://hooks.example\r\nX: y/",
            &format!("https://hooks.example/{}", "x".repeat(MAX_URL)),
        ] {
            assert_eq!(read(text), Err(NotADestination), "{text}");
        }
    }
}
