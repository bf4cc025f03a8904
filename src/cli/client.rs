//! A small HTTP client for the program's own questions to a service: one request, one connection.

use std::net::SocketAddr;

use bytes::Bytes;
use http_body_util::{BodyExt, Full};
use hyper::header::{CONTENT_TYPE, HOST};
use hyper::{Request, StatusCode};
use hyper_util::rt::TokioIo;
use serde::de::DeserializeOwned;
use thiserror::Error;
use tokio::net::TcpStream;

/// Why a request has no answer that one can use.
#[derive(Debug, Error)]
#[error("{0}")]
pub(super) struct RequestError(String);

/// Talks to one service.
#[derive(Debug, Clone, Copy)]
pub(super) struct Client {
    pub(super) address: SocketAddr,
}

impl Client {
    /// GETs a document.
    pub(super) async fn get<T: DeserializeOwned>(&self, path: &str) -> Result<T, RequestError> {
        self.send("GET", path, Bytes::new()).await
    }

    /// POSTs JSON and takes the answer.
    pub(super) async fn post<T: DeserializeOwned>(&self, path: &str, json: Bytes) -> Result<T, RequestError> {
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
        let (mut sender, connection) = hyper::client::conn::http1::handshake(TokioIo::new(stream)).await?;
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
