//! An open line: serial, TCP or UDP, read and written by one task without either waiting for the other.

use super::contacts::Lines;
use std::io;
use std::pin::Pin;
use std::task::{Context, Poll, ready};
use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};
use tokio::net::{TcpStream, UdpSocket};
use tokio_serial::{ClearBuffer, SerialPort, SerialStream};

/// A line that is open.
#[derive(Debug)]
pub(super) enum Wire {
    Serial(SerialStream),
    Tcp(TcpStream),
    /// A socket; connected where something may be sent.
    Udp(UdpSocket),
}

/// What happened on a line.
#[derive(Debug)]
pub(super) enum Moved {
    /// So many bytes were read.
    Read(usize),
    /// So many bytes were written.
    Written(usize),
}

impl Wire {
    /// Reads into `buffer`, where there is one, or writes from `rest`, whichever can be done first.
    pub(super) fn poll(
        &mut self,
        cx: &mut Context<'_>,
        buffer: Option<&mut [u8]>,
        rest: &[u8],
    ) -> Poll<io::Result<Moved>> {
        if let Some(buffer) = buffer
            && let Poll::Ready(read) = self.poll_read(cx, buffer)
        {
            return Poll::Ready(match read {
                // A serial device that is gone reads as its end, for ever (FB8).
                Ok(0) => Err(io::ErrorKind::UnexpectedEof.into()),
                read => read.map(Moved::Read),
            });
        }
        if rest.is_empty() {
            return Poll::Pending;
        }
        let written = match self {
            Self::Serial(port) => ready!(Pin::new(port).poll_write(cx, rest)),
            Self::Tcp(stream) => ready!(Pin::new(stream).poll_write(cx, rest)),
            Self::Udp(socket) => match ready!(socket.poll_send(cx, rest)) {
                // Nobody hears it: that is no fault of ours.
                Err(error) if error.kind() == io::ErrorKind::ConnectionRefused => Ok(rest.len()),
                sent => sent,
            },
        };
        Poll::Ready(match written {
            Ok(0) => Err(io::ErrorKind::WriteZero.into()),
            written => written.map(Moved::Written),
        })
    }

    fn poll_read(&mut self, cx: &mut Context<'_>, buffer: &mut [u8]) -> Poll<io::Result<usize>> {
        let mut buffer = ReadBuf::new(buffer);
        match self {
            Self::Serial(port) => ready!(Pin::new(port).poll_read(cx, &mut buffer))?,
            Self::Tcp(stream) => ready!(Pin::new(stream).poll_read(cx, &mut buffer))?,
            Self::Udp(socket) => loop {
                match ready!(socket.poll_recv(cx, &mut buffer)) {
                    Ok(()) if buffer.filled().is_empty() => {}
                    Ok(()) => break,
                    Err(error) if error.kind() == io::ErrorKind::ConnectionRefused => {}
                    Err(error) => return Poll::Ready(Err(error)),
                }
            },
        }
        Poll::Ready(Ok(buffer.filled().len()))
    }

    /// Bytes that the system holds back, where it can say.
    pub(super) fn held_back(&self) -> u32 {
        match self {
            Self::Serial(port) => port.bytes_to_write().unwrap_or(0),
            Self::Tcp(_) | Self::Udp(_) => 0,
        }
    }

    /// Its control lines, where it has any.
    pub(super) fn control_lines(&mut self) -> Option<&mut dyn Lines> {
        match self {
            Self::Serial(port) => Some(port),
            Self::Tcp(_) | Self::Udp(_) => None,
        }
    }

    /// Drops what the system holds back, where that can be done.
    pub(super) fn discard(&self) {
        if let Self::Serial(port) = self {
            let _ = port.clear(ClearBuffer::Output);
        }
    }
}
