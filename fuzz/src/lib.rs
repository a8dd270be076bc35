//! What fuzz targets share.

pub mod served;
