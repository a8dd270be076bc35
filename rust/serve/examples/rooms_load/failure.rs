//! The error of everything here.

pub type Failure = Box<dyn std::error::Error + Send + Sync>;
