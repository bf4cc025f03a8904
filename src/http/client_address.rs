//! The address of a client, also behind proxies.

use std::net::{IpAddr, SocketAddr};
use std::str::FromStr;

use axum::http::HeaderMap;

/// The other end of a connection.
#[derive(Debug, Clone, Copy)]
pub(super) struct Peer(pub(super) SocketAddr);

/// Addresses with the same first bits, as `10.0.0.0/8`, or one address.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Network {
    address: IpAddr,
    bits: u32,
}

impl Network {
    fn contains(self, address: IpAddr) -> bool {
        let (network, address) = (self.address.to_canonical(), address.to_canonical());
        let (size, differing) = match (network, address) {
            (IpAddr::V4(a), IpAddr::V4(b)) => (32, u128::from(a.to_bits() ^ b.to_bits())),
            (IpAddr::V6(a), IpAddr::V6(b)) => (128, a.to_bits() ^ b.to_bits()),
            _ => return false,
        };
        differing.checked_shr(size - self.bits.min(size)).unwrap_or(0) == 0
    }
}

impl FromStr for Network {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (address, bits) = text.split_once('/').unwrap_or((text, ""));
        let wrong = || format!("{text:?} is no address and no network like 10.0.0.0/8");
        let address: IpAddr = address.parse().map_err(|_| wrong())?;
        let most = if address.is_ipv4() { 32 } else { 128 };
        let bits = if bits.is_empty() { most } else { bits.parse().map_err(|_| wrong())? };
        if bits > most { Err(wrong()) } else { Ok(Self { address, bits }) }
    }
}

/// Returns the address of the client: that of the connection or, if a trusted proxy has made it,
/// the last address in `X-Forwarded-For` that is none of a trusted proxy. Further ones are what
/// the client says itself.
pub(super) fn client_address(
    peer: Option<Peer>,
    headers: &HeaderMap,
    trusted: &[Network],
) -> Option<IpAddr> {
    let mut client = peer?.0.ip().to_canonical();
    let lines = headers.get_all("x-forwarded-for").iter().filter_map(|line| line.to_str().ok());
    let forwarded: Vec<&str> = lines.flat_map(|line| line.split(',')).collect();
    for address in forwarded.iter().rev() {
        let Ok(address) = address.trim().parse::<IpAddr>() else { break };
        if !trusted.iter().any(|network| network.contains(client)) {
            break;
        }
        client = address.to_canonical();
    }
    Some(client)
}

#[cfg(test)]
mod tests {
    use axum::http::HeaderValue;

    use super::*;

    #[test]
    fn the_address_before_trusted_proxies_is_the_client() {
        let trusted: Vec<Network> =
            ["10.0.0.0/8", "192.0.2.1", "fd00::/8"].map(|text| text.parse().unwrap()).into();
        let client = |peer: &str, line: &'static str| {
            let peer = Peer(SocketAddr::new(peer.parse().unwrap(), 1));
            let mut headers = HeaderMap::new();
            headers.insert("x-forwarded-for", HeaderValue::from_static(line));
            client_address(Some(peer), &headers, &trusted).unwrap().to_string()
        };
        assert_eq!(client("203.0.113.5", "198.51.100.7"), "203.0.113.5", "no proxy of ours");
        assert_eq!(client("10.1.2.3", "198.51.100.7"), "198.51.100.7");
        assert_eq!(client("::ffff:10.1.2.3", "198.51.100.7"), "198.51.100.7");
        assert_eq!(client("fd00::1", "forged, 198.51.100.7, 192.0.2.1"), "198.51.100.7");
        assert_eq!(client("10.1.2.3", "198.51.100.7, nonsense"), "10.1.2.3");
        assert_eq!(client("192.0.2.2", "198.51.100.7"), "192.0.2.2");
        for wrong in ["10.0.0.0/33", "10.0.0/8", "", "x", "::/129"] {
            assert!(wrong.parse::<Network>().is_err(), "{wrong}");
        }
    }
}
