//! Errors of wgpu as sentences that name the adapter and a remedy.

use nearfar_core::base::{Error, Result};
use wgpu::{ErrorFilter, ErrorScopeGuard};

use super::Device;
use super::registry::FORKED;

/// Catches errors that wgpu reports while the scope is open; uncaught errors would end the process.
#[must_use]
pub(crate) struct Scope<'a> {
    device: &'a Device,
    guards: [ErrorScopeGuard; 3],
}

impl<'a> Scope<'a> {
    pub fn open(device: &'a Device) -> Self {
        let filters = [ErrorFilter::Validation, ErrorFilter::Internal, ErrorFilter::OutOfMemory];
        let mut guards = filters.map(|filter| device.wgpu.push_error_scope(filter));
        // Scopes must close in the opposite order, even when they are dropped because of another error.
        guards.reverse();
        Self { device, guards }
    }

    /// Returns the reported error, if any. Loss of the device takes precedence, because other errors follow from it.
    pub fn close(self) -> Result<()> {
        let errors = self.guards.map(|guard| pollster::block_on(guard.pop()));
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
        let reason = one_line(&error.to_string());
        Error::Device(match error {
            wgpu::Error::OutOfMemory { .. } => {
                format!("{label}: out of memory ({reason}); try a smaller scene, image or face_size, or backend='cpu'")
            }
            wgpu::Error::Validation { .. } => {
                format!("{label}: refused ({reason}); update its driver, or use backend='cpu'")
            }
            wgpu::Error::Internal { .. } => {
                format!("{label}: failed ({reason}); update its driver, or use backend='cpu'")
            }
        })
    }
}

fn one_line(text: &str) -> String {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if text.is_empty() { "no reason given".to_string() } else { text }
}

#[cfg(test)]
mod tests {
    use wgpu::{BufferDescriptor, BufferUsages, ShaderModuleDescriptor, ShaderSource};

    use super::*;
    use crate::device::{adapters, device};

    fn devices() -> Vec<std::sync::Arc<Device>> {
        let usable = adapters().unwrap().into_iter().filter(|report| report.refused.is_empty());
        let mut names: Vec<&str> = usable.map(|report| report.backend).collect();
        names.dedup();
        names.into_iter().map(|name| device(Some(name)).unwrap()).collect()
    }

    #[test]
    fn a_shader_error_has_a_message_and_the_device_survives() {
        for device in devices() {
            let scope = Scope::open(&device);
            let source = ShaderSource::Wgsl("fn broken( {".into());
            let _ = device.wgpu.create_shader_module(ShaderModuleDescriptor { label: None, source });
            let Err(Error::Device(message)) = scope.close() else { panic!("no error") };
            assert!(
                message.starts_with(&device.report().label())
                    && message.contains("refused (")
                    && !message.contains('\n'),
                "{message}"
            );
            let scope = Scope::open(&device);
            let _ = device.wgpu.create_buffer(&BufferDescriptor {
                label: None,
                size: 256,
                usage: BufferUsages::STORAGE,
                mapped_at_creation: false,
            });
            scope.close().unwrap();
        }
    }

    #[test]
    fn scopes_that_another_error_leaves_open_close_in_order() {
        for device in devices() {
            let outer = Scope::open(&device);
            drop(Scope::open(&device));
            outer.close().unwrap();
        }
    }
}
