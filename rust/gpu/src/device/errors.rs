//! Errors of wgpu as sentences that name the adapter and say what to try.

use nearfar_core::base::{Error, Result};
use wgpu::{ErrorFilter, ErrorScopeGuard};

use super::Device;
use super::registry::FORKED;

/// Catches what wgpu reports while it is open; errors outside of any scope would end the process.
#[must_use]
pub(crate) struct Scope<'a> {
    device: &'a Device,
    guards: [ErrorScopeGuard; 3],
}

impl<'a> Scope<'a> {
    pub fn open(device: &'a Device) -> Self {
        let filters = [ErrorFilter::Validation, ErrorFilter::Internal, ErrorFilter::OutOfMemory];
        Self { device, guards: filters.map(|filter| device.wgpu.push_error_scope(filter)) }
    }

    /// What was reported, if anything; the loss of the device before all others, which follow from it.
    pub fn close(self) -> Result<()> {
        // Scopes close in the opposite order.
        let [validation, internal, memory] = self.guards;
        let errors = [memory, internal, validation].map(|guard| pollster::block_on(guard.pop()));
        self.device.check()?;
        match errors.into_iter().flatten().next() {
            None => Ok(()),
            Some(error) => Err(self.device.error(&error)),
        }
    }
}

impl Device {
    /// Fails once the device was lost, and in a forked child.
    pub(crate) fn check(&self) -> Result<()> {
        if self.process != std::process::id() {
            return Err(Error::Device(format!("{}: {FORKED}", self.report.label())));
        }
        match self.lost_because() {
            None => Ok(()),
            Some(reason) => Err(Error::Device(format!(
                "{}: the device was lost ({}); the next call opens it again, backend='cpu' needs none",
                self.report.label(),
                one_line(&reason)
            ))),
        }
    }

    fn error(&self, error: &wgpu::Error) -> Error {
        let label = self.report.label();
        let said = one_line(&error.to_string());
        Error::Device(match error {
            wgpu::Error::OutOfMemory { .. } => {
                format!("{label}: out of memory ({said}); try a smaller scene, image or face_size, or backend='cpu'")
            }
            wgpu::Error::Validation { .. } => {
                format!("{label}: refused ({said}); update its driver, or use backend='cpu'")
            }
            wgpu::Error::Internal { .. } => {
                format!("{label}: failed ({said}); update its driver, or use backend='cpu'")
            }
        })
    }
}

fn one_line(text: &str) -> String {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if text.is_empty() { "no reason given".to_string() } else { text }
}
