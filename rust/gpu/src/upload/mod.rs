//! Scenes kept on the device between frames: meshes by identity, materials and textures, instances as transforms.

mod environment;
mod materials;
mod pages;
mod records;
mod residents;
mod runs;
mod shelf;
mod tables;
mod texels;

pub(crate) use environment::EnvTexels;
pub(crate) use pages::Page;
pub(crate) use records::{RECORD_WORDS, Records};
pub(crate) use residents::{Placeholders, Residents};
pub(crate) use runs::CHUNK;
pub(crate) use tables::{InstanceParts, PART_WORDS, SceneTables, SetTables};
pub(crate) use texels::Texels;
