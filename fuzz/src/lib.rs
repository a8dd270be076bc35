//! Parts that fuzz targets share.

pub mod served;
