//! Pipelines, each compiled once per device.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::Mutex;

use nearfar_core::base::Result;

use super::{Device, Scope, lock};

/// Compiled pipelines by their settings.
pub(crate) struct Compiled<K, P>(Mutex<HashMap<K, P>>);

impl<K, P> Default for Compiled<K, P> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<K: Eq + Hash, P: Clone> Compiled<K, P> {
    /// Returns the pipeline of some settings; compiles it on first use.
    pub fn get(&self, device: &Device, settings: K, compile: impl FnOnce(&K) -> P) -> Result<P> {
        let mut compiled = lock(&self.0);
        if let Some(pipeline) = compiled.get(&settings) {
            return Ok(pipeline.clone());
        }
        let scope = Scope::open(device);
        let pipeline = compile(&settings);
        scope.close()?;
        compiled.insert(settings, pipeline.clone());
        Ok(pipeline)
    }
}
