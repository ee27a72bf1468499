//! Standard output whose reader may leave: `kane check | head`.

use std::io::{self, BufWriter, Write};

/// A buffered writer that takes everything and keeps nothing once its reader is gone, so that the command ends as it
/// would have ended.
#[derive(Debug)]
pub(crate) struct Pipe<W: Write>(BufWriter<Quiet<W>>);

/// A writer for which a closed pipe is no error.
#[derive(Debug)]
struct Quiet<W>(W);

impl<W: Write> Pipe<W> {
    /// A pipe to `inner`.
    pub(crate) fn new(inner: W) -> Self {
        Self(BufWriter::new(Quiet(inner)))
    }
}

impl<W: Write> Write for Pipe<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

impl<W: Write> Write for Quiet<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.0.write(bytes) {
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(bytes.len()),
            result => result,
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self.0.flush() {
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
            result => result,
        }
    }
}
