//! Error type of the example.

pub type Failure = Box<dyn std::error::Error + Send + Sync>;
