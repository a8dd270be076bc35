//! A number for each face of a mesh (its object, its material), stored as tightly as the mesh allows.

use crate::base::{Buffer, Error, Result};

/// Which object or material a face belongs to; −1 stands for none.
#[derive(Clone, Debug)]
pub enum FaceMap {
    /// The whole mesh has one value.
    Uniform(i32),
    /// Consecutive faces share values: `starts` (ascending, the first 0) and the value from each start on.
    Ranges {
        /// First face of each range.
        starts: Buffer<u32>,
        /// Value of each range.
        values: Buffer<i32>,
    },
    /// A value for every face.
    PerFace(Buffer<i32>),
}

impl FaceMap {
    /// The value of a face.
    #[inline]
    pub fn get(&self, face: u32) -> i32 {
        match self {
            Self::Uniform(value) => *value,
            Self::Ranges { starts, values } => values[starts.partition_point(|&start| start <= face) - 1],
            Self::PerFace(values) => values[face as usize],
        }
    }

    /// Checks that every one of `face_count` faces has a value below `limit`.
    pub fn validate(&self, argument: &'static str, face_count: usize, limit: i32) -> Result<()> {
        let (values, well_formed) = match self {
            Self::Uniform(value) => (std::slice::from_ref(value), true),
            Self::Ranges { starts, values } => (
                &values[..],
                starts.len() == values.len()
                    && starts.first() == Some(&0)
                    && starts.windows(2).all(|pair| pair[0] < pair[1])
                    && starts.last().is_some_and(|&last| face_count == 0 || (last as usize) < face_count),
            ),
            Self::PerFace(values) => (&values[..], values.len() == face_count),
        };
        if !well_formed {
            return Err(Error::value(argument, format!("one value for each of {face_count} faces"), "another layout"));
        }
        match values.iter().find(|&&value| value < -1 || value >= limit) {
            Some(value) => Err(Error::value(argument, format!("numbers from -1 to {}", limit - 1), value)),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_layouts_answer_alike() {
        let wide = FaceMap::PerFace(vec![4, 4, 4, 2, 2, 0].into());
        let ranges = FaceMap::Ranges { starts: vec![0, 3, 5].into(), values: vec![4, 2, 0].into() };
        for face in 0..6 {
            assert_eq!(wide.get(face), ranges.get(face));
        }
        assert!(wide.validate("x", 6, 5).is_ok() && ranges.validate("x", 6, 5).is_ok());
        assert!(wide.validate("x", 7, 5).is_err() && wide.validate("x", 6, 4).is_err());
        assert!(ranges.validate("x", 5, 5).is_err());
        assert_eq!(FaceMap::Uniform(7).get(123), 7);
    }
}
