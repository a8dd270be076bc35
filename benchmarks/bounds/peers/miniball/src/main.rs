//! Reads points from a file of raw float64 triples; for each line on standard input, whatever its text, computes their
//! smallest sphere anew with the crate and prints its radius.

use std::collections::VecDeque;
use std::io::{self, BufRead, Write};

use miniball::nalgebra::Point3;
use miniball::{Ball, Enclosing};

fn main() -> io::Result<()> {
    let path = std::env::args().nth(1).ok_or_else(|| io::Error::other("expected a file of points"))?;
    let bytes = std::fs::read(path)?;
    let numbers: Vec<f64> = bytes.chunks_exact(8).map(|b| f64::from_ne_bytes(b.try_into().unwrap_or_default())).collect();
    let points: VecDeque<_> = numbers.chunks_exact(3).map(|p| Point3::new(p[0], p[1], p[2])).collect();
    for line in io::stdin().lock().lines() {
        line?;
        // The crate moves points on the surface to the front, hence a fresh copy each time, as in a first call.
        let ball = Ball::enclosing_points(&mut points.clone());
        println!("{:e}", ball.radius_squared.sqrt());
        io::stdout().flush()?;
    }
    Ok(())
}
