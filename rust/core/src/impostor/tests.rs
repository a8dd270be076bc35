//! Tests of impostors.
