//! Scenes kept on the device between frames: meshes by identity, materials and textures, instances as transforms.

mod pages;
mod residents;
mod runs;
mod tables;
mod texels;

pub(crate) use pages::Page;
pub(crate) use residents::{Placeholders, Residents};
pub(crate) use runs::CHUNK;
pub(crate) use tables::{InstanceParts, PART_WORDS, RECORD_WORDS, Records, SceneTables, SetTables};
pub(crate) use texels::EnvTexels;
