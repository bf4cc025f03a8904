//! A small HTTP client for requests of this program to a service: one request, one connection.

use std::net::SocketAddr;
use std::path::Path;
use std::sync::Arc;

use bytes::Bytes;
use http_body_util::{BodyExt, Full};
use hyper::header::{CONTENT_TYPE, HOST};
use hyper::{Request, StatusCode};
use hyper_util::rt::TokioIo;
use rustls::client::danger::{HandshakeSignatureValid, ServerCertVerified, ServerCertVerifier};
use rustls::crypto::ring::default_provider;
use rustls::crypto::{
    CryptoProvider, WebPkiSupportedAlgorithms, verify_tls12_signature, verify_tls13_signature,
};
use rustls::pki_types::pem::PemObject;
use rustls::pki_types::{CertificateDer, ServerName, UnixTime};
use rustls::{ClientConfig, DigitallySignedStruct, Error as TlsError, SignatureScheme};
use serde::de::DeserializeOwned;
use thiserror::Error;
use tokio::io::{AsyncRead, AsyncWrite};
use tokio::net::TcpStream;
use tokio_rustls::TlsConnector;

/// An error of a request.
#[derive(Debug, Error)]
#[error("{0}")]
pub(super) struct RequestError(String);

/// A client of one service.
#[derive(Clone)]
pub(super) struct Client {
    pub(super) address: SocketAddr,
    tls: Option<TlsConnector>,
}

impl Client {
    /// Makes a client without TLS.
    pub(super) const fn new(address: SocketAddr) -> Self {
        Self { address, tls: None }
    }

    /// Makes a client with TLS that trusts only the first certificate of a file (PEM).
    pub(super) fn pinned(address: SocketAddr, certificate: &Path) -> Result<Self, RequestError> {
        let certificate = CertificateDer::from_pem_file(certificate);
        let certificate = certificate.map_err(|error| failed(format!("certificate: {error}")))?;
        let provider = Arc::new(default_provider());
        let trust = Arc::new(Pinned { certificate, provider: Arc::clone(&provider) });
        let config =
            ClientConfig::builder_with_provider(provider).with_safe_default_protocol_versions();
        let config = config.map_err(failed)?.dangerous().with_custom_certificate_verifier(trust);
        Ok(Self { address, tls: Some(TlsConnector::from(Arc::new(config.with_no_client_auth()))) })
    }

    /// GETs a document.
    pub(super) async fn get<T: DeserializeOwned>(&self, path: &str) -> Result<T, RequestError> {
        self.send("GET", path, Bytes::new()).await
    }

    /// POSTs JSON and returns the answer.
    pub(super) async fn post<T: DeserializeOwned>(
        &self,
        path: &str,
        json: Bytes,
    ) -> Result<T, RequestError> {
        self.send("POST", path, json).await
    }

    async fn send<T: DeserializeOwned>(
        &self,
        method: &str,
        path: &str,
        json: Bytes,
    ) -> Result<T, RequestError> {
        let (status, text) = self.log(method, path, json).await.map_err(failed)?;
        if !status.is_success() {
            let answer = String::from_utf8_lossy(&text);
            return Err(RequestError(format!("{method} {path}: {status}: {answer}")));
        }
        serde_json::from_slice(&text).map_err(failed)
    }

    async fn log(
        &self,
        method: &str,
        path: &str,
        json: Bytes,
    ) -> Result<(StatusCode, Bytes), Box<dyn std::error::Error>> {
        let stream = TcpStream::connect(self.address).await?;
        let Some(tls) = &self.tls else { return self.exchange(stream, method, path, json).await };
        let stream = tls.connect(self.address.ip().into(), stream).await?;
        self.exchange(stream, method, path, json).await
    }

    async fn exchange(
        &self,
        stream: impl AsyncRead + AsyncWrite + Unpin + Send + 'static,
        method: &str,
        path: &str,
        json: Bytes,
    ) -> Result<(StatusCode, Bytes), Box<dyn std::error::Error>> {
        let (mut sender, connection) =
            hyper::client::conn::http1::handshake(TokioIo::new(stream)).await?;
        let connection = tokio::spawn(connection);
        let request = Request::builder()
            .method(method)
            .uri(path)
            .header(HOST, self.address.to_string())
            .header(CONTENT_TYPE, "application/json")
            .body(Full::new(json))?;
        let response = sender.send_request(request).await?;
        let status = response.status();
        let text = response.into_body().collect().await?.to_bytes();
        drop(sender);
        connection.abort();
        Ok((status, text))
    }
}

#[expect(clippy::needless_pass_by_value, reason = "for map_err")]
fn failed(error: impl ToString) -> RequestError {
    RequestError(error.to_string())
}

/// A verifier that trusts one certificate, whatever its host name and age.
#[derive(Debug)]
struct Pinned {
    certificate: CertificateDer<'static>,
    provider: Arc<CryptoProvider>,
}

impl Pinned {
    fn algorithms(&self) -> &WebPkiSupportedAlgorithms {
        &self.provider.signature_verification_algorithms
    }
}

impl ServerCertVerifier for Pinned {
    fn verify_server_cert(
        &self,
        shown: &CertificateDer<'_>,
        _: &[CertificateDer<'_>],
        _: &ServerName<'_>,
        _: &[u8],
        _: UnixTime,
    ) -> Result<ServerCertVerified, TlsError> {
        if *shown == self.certificate {
            Ok(ServerCertVerified::assertion())
        } else {
            Err(TlsError::General("the service has another certificate".to_owned()))
        }
    }

    fn verify_tls12_signature(
        &self,
        message: &[u8],
        certificate: &CertificateDer<'_>,
        signature: &DigitallySignedStruct,
    ) -> Result<HandshakeSignatureValid, TlsError> {
        verify_tls12_signature(message, certificate, signature, self.algorithms())
    }

    fn verify_tls13_signature(
        &self,
        message: &[u8],
        certificate: &CertificateDer<'_>,
        signature: &DigitallySignedStruct,
    ) -> Result<HandshakeSignatureValid, TlsError> {
        verify_tls13_signature(message, certificate, signature, self.algorithms())
    }

    fn supported_verify_schemes(&self) -> Vec<SignatureScheme> {
        self.algorithms().supported_schemes()
    }
}
