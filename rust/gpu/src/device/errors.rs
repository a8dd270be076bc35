//! Errors of wgpu as sentences that name the adapter and a remedy.

use std::fmt::Display;

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
        errors.into_iter().flatten().next().map_or(Ok(()), |error| Err(self.device.wgpu_error(&error)))
    }
}

impl Device {
    /// Fails once the device was lost, and in a forked child.
    pub(crate) fn check(&self) -> Result<()> {
        if self.process != std::process::id() {
            return Err(self.error(FORKED));
        }
        let Some(reason) = self.loss_reason() else { return Ok(()) };
        Err(self.error(format!(
            "the device was lost ({}); the next call opens it again, backend='cpu' needs none",
            one_line(&reason)
        )))
    }

    /// Returns an error whose message begins with the adapter's label.
    pub(crate) fn error(&self, message: impl Display) -> Error {
        Error::Device(format!("{}: {message}", self.report.label()))
    }

    /// Returns the loss of the device if it was lost, because other errors follow from it; otherwise the error.
    pub(crate) fn failure(&self, error: impl Display) -> Error {
        self.check().err().unwrap_or_else(|| self.error(error))
    }

    fn wgpu_error(&self, error: &wgpu::Error) -> Error {
        let (event, remedy) = match error {
            wgpu::Error::OutOfMemory { .. } => ("out of memory", "try a smaller scene, image or face_size, or"),
            wgpu::Error::Validation { .. } => ("refused", "update its driver, or use"),
            wgpu::Error::Internal { .. } => ("failed", "update its driver, or use"),
        };
        self.error(format!("{event} ({}); {remedy} backend='cpu'", one_line(&error.to_string())))
    }
}

fn one_line(text: &str) -> String {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if text.is_empty() { "no reason given".to_string() } else { text }
}

#[cfg(test)]
mod tests {
    use wgpu::{BufferUsages, ShaderModuleDescriptor, ShaderSource};

    use super::*;
    use crate::device::{adapters, device};

    fn devices() -> Vec<std::sync::Arc<Device>> {
        let usable = adapters().unwrap().into_iter().filter(|report| report.refusal_reason.is_empty());
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
            assert!(message.starts_with(&device.report().label()) && message.contains("refused ("), "{message}");
            assert!(!message.contains('\n'), "{message}");
            device.buffer("any", 256, BufferUsages::STORAGE).unwrap();
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
