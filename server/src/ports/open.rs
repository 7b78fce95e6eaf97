//! Opening what a port leads to, and telling "not there" from "taken".

use super::wire::Wire;
use crate::clock::Tempo;
use crate::config::{Place, pseudo_terminal};
use crate::error::reason;
use std::io;
use std::net::{IpAddr, Ipv4Addr, SocketAddr};
use std::path::PathBuf;
use std::time::Duration;
use tokio::net::{TcpListener, TcpSocket, TcpStream, UdpSocket, lookup_host};
use tokio_serial::{DataBits, ErrorKind, FlowControl, Parity, SerialPortBuilderExt, StopBits};

/// A server that does not answer for this long counts as absent.
const CALL_TIMEOUT: Duration = Duration::from_secs(2);
/// Small, so that a reader that stops is seen soon and little that is old stands in the system's queue.
const SEND_BUFFER: u32 = 4096;
/// Small, so that what is heard of a line that floods is not old.
const RECEIVE_BUFFER: u32 = 16 * 1024;

/// What was opened.
#[derive(Debug)]
pub(super) enum Opened {
    /// A line.
    Wire(Wire),
    /// A place where a client may call.
    Listener(TcpListener),
    /// A recording to be played.
    Recording(PathBuf),
}

/// Why a port could not be opened.
#[derive(Debug)]
pub(super) struct Failure {
    /// It is there, but another program has it.
    pub(super) taken: bool,
    /// In an officer's words.
    pub(super) text: String,
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self {
            taken: error.kind() == io::ErrorKind::AddrInUse,
            text: reason(&error),
        }
    }
}

/// Opens a port. In a trial at another pace a name that was pointed to real equipment meanwhile is not opened.
pub(super) async fn open(place: &Place, tempo: Tempo) -> Result<Opened, Failure> {
    match place {
        Place::File(path) => {
            tokio::fs::metadata(path).await?;
            Ok(Opened::Recording(path.clone()))
        }
        Place::Serial(path, baud) if tempo.is_trial() => match pseudo_terminal(path) {
            Ok(device) => serial(&device.to_string_lossy(), *baud),
            Err(text) => Err(Failure { taken: false, text }),
        },
        Place::Serial(path, baud) => serial(&path.to_string_lossy(), *baud),
        Place::TcpClient(address) => call(address).await,
        Place::TcpServer(address) => {
            let socket = match address {
                SocketAddr::V4(_) => TcpSocket::new_v4()?,
                SocketAddr::V6(_) => TcpSocket::new_v6()?,
            };
            socket.set_reuseaddr(true)?;
            socket.set_send_buffer_size(SEND_BUFFER)?;
            socket.set_recv_buffer_size(RECEIVE_BUFFER)?;
            socket
                .bind(*address)
                .map_err(|error| at(*address, &error))?;
            Ok(Opened::Listener(socket.listen(4)?))
        }
        Place::Udp(address) => datagrams(*address).await,
    }
}

fn at(address: SocketAddr, error: &io::Error) -> Failure {
    let taken = error.kind() == io::ErrorKind::AddrInUse;
    let text = if taken {
        format!("address {address} is in use by another program")
    } else {
        format!("{address}: {}", reason(error))
    };
    Failure { taken, text }
}

fn serial(path: &str, baud: u32) -> Result<Opened, Failure> {
    tokio_serial::new(path, baud)
        .data_bits(DataBits::Eight)
        .parity(Parity::None)
        .stop_bits(StopBits::One)
        .flow_control(FlowControl::None)
        .open_native_async()
        .map(|port| Opened::Wire(Wire::Serial(port)))
        .map_err(|error| {
            // The library's name for a device that another program holds, by lock or by its mode.
            let taken = error.kind() == ErrorKind::NoDevice;
            let text = if taken {
                format!("{path} is in use by another program")
            } else {
                let words = error.to_string().to_lowercase();
                format!("{path}: {words}")
            };
            Failure { taken, text }
        })
}

async fn call(address: &str) -> Result<Opened, Failure> {
    let calling = async {
        let mut last = io::Error::from(io::ErrorKind::NotFound);
        for target in lookup_host(address).await? {
            let socket = match target {
                SocketAddr::V4(_) => TcpSocket::new_v4()?,
                SocketAddr::V6(_) => TcpSocket::new_v6()?,
            };
            // Before the call: the size is agreed in it.
            socket.set_recv_buffer_size(RECEIVE_BUFFER)?;
            match socket.connect(target).await {
                Ok(stream) => {
                    prepare(&stream);
                    return Ok(Opened::Wire(Wire::Tcp(stream)));
                }
                Err(error) => last = error,
            }
        }
        Err(last)
    };
    match tokio::time::timeout(CALL_TIMEOUT, calling).await {
        Ok(Ok(opened)) => Ok(opened),
        Ok(Err(error)) => Err(Failure {
            taken: false,
            text: format!("{address}: {}", reason(&error)),
        }),
        Err(_) => Err(Failure {
            taken: false,
            text: format!("{address} does not answer"),
        }),
    }
}

/// A half-open connection is found out within seconds, and orders are not held back to be joined.
pub(super) fn prepare(stream: &TcpStream) {
    let socket = socket2::SockRef::from(stream);
    let alive = socket2::TcpKeepalive::new()
        .with_time(Duration::from_secs(2))
        .with_interval(Duration::from_secs(1))
        .with_retries(3);
    let _ = socket.set_tcp_keepalive(&alive);
    let _ = socket.set_send_buffer_size(SEND_BUFFER as usize);
    let _ = stream.set_nodelay(true);
}

async fn datagrams(address: SocketAddr) -> Result<Opened, Failure> {
    let any = IpAddr::V4(Ipv4Addr::UNSPECIFIED);
    let socket = match address.ip() {
        ip if ip.is_unspecified() => UdpSocket::bind(address)
            .await
            .map_err(|e| at(address, &e))?,
        IpAddr::V4(group) if group.is_multicast() => {
            let here = SocketAddr::new(any, address.port());
            let socket = UdpSocket::bind(here).await.map_err(|e| at(here, &e))?;
            socket.join_multicast_v4(group, Ipv4Addr::UNSPECIFIED)?;
            socket
        }
        ip => {
            // Heard and answered from one place only (FE11).
            let here = if ip.is_ipv4() {
                any
            } else {
                IpAddr::from([0_u16; 8])
            };
            let socket = UdpSocket::bind((here, 0)).await?;
            socket.set_broadcast(true)?;
            socket.connect(address).await?;
            socket
        }
    };
    socket2::SockRef::from(&socket).set_recv_buffer_size(RECEIVE_BUFFER as usize)?;
    Ok(Opened::Wire(Wire::Udp(socket)))
}
