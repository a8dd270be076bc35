//! Support for all stages: errors, threads, progress, random numbers, shared arrays, boxes, values per face.

pub mod aabb;
pub mod buffer;
pub mod error;
pub mod face_map;
pub(crate) mod mapped;
pub mod memory;
pub mod pool;
pub mod progress;
pub mod random;
pub mod real;
pub(crate) mod simd;
pub(crate) mod sort;

pub use aabb::{Aabb, MAX_COORDINATE};
pub use buffer::Buffer;
pub(crate) use error::ensure;
pub use error::{Error, Result, number};
pub use face_map::FaceMap;
pub(crate) use face_map::{by_number, by_object};
pub use progress::Progress;
pub use real::Real;
