//! Map from the faces of a mesh to their object or material numbers, in the smallest suitable layout.

use rayon::prelude::*;

use super::mapped::{mapped, starts};
use super::memory::{try_list, try_push, try_with_capacity};
use super::{Buffer, Error, Progress, Result, ensure};

/// Minimum mean length of a run, in faces, at which `Ranges` replaces `PerFace`. Ranges save up to 4 bytes per face,
/// beside 12 bytes of indices and the tree, but a look-up is a binary search instead of one load.
const FACES_PER_RUN: usize = 64;

/// The object or material of each face; −1 stands for none.
#[derive(Clone, Debug)]
pub enum FaceMap {
    /// All faces have the same value.
    Uniform(i32),
    /// Consecutive faces share values: `starts` is ascending from 0, and each value holds from its start to the next.
    Ranges {
        /// First face of each range.
        starts: Buffer<u32>,
        /// Value of each range.
        values: Buffer<i32>,
    },
    /// One value per face.
    PerFace(Buffer<i32>),
}

/// Returns the value of an object or a material by its number; `None` for −1 and numbers beyond the end.
#[inline]
pub(crate) fn by_number<T>(values: &[T], number: i32) -> Option<&T> {
    usize::try_from(number).ok().and_then(|number| values.get(number))
}

/// Returns the value of an object. The last entry of `values` is for faces without an object; if it is the only one, it is
/// for all objects, too.
pub(crate) fn by_object<T>(values: &[T], object: i32) -> &T {
    let last = values.len() - 1;
    &values[usize::try_from(object).map_or(last, |object| object.min(last))]
}

impl FaceMap {
    /// Returns the value of one face.
    #[inline]
    pub fn get(&self, face: u32) -> i32 {
        match self {
            Self::Uniform(value) => *value,
            Self::Ranges { starts, values } => values[starts.partition_point(|&start| start <= face) - 1],
            Self::PerFace(values) => values[face as usize],
        }
    }

    /// Returns the memory of the arrays, bytes.
    pub fn bytes(&self) -> usize {
        match self {
            Self::Uniform(_) => 0,
            Self::Ranges { starts, values } => size_of_val(&starts[..]) + size_of_val(&values[..]),
            Self::PerFace(values) => size_of_val(&values[..]),
        }
    }

    /// Returns runs of equal values as (first face, value), for a mesh of `face_count` faces.
    pub fn runs(&self, face_count: usize) -> Box<dyn Iterator<Item = (usize, i32)> + '_> {
        match self {
            _ if face_count == 0 => Box::new(std::iter::empty()),
            Self::Uniform(value) => Box::new(std::iter::once((0, *value))),
            Self::Ranges { starts, values } => {
                Box::new(starts.iter().map(|&start| start as usize).zip(values.iter().copied()))
            }
            Self::PerFace(values) => Box::new(
                (0..face_count)
                    .filter(|&face| face == 0 || values[face] != values[face - 1])
                    .map(|face| (face, values[face])),
            ),
        }
    }

    /// Joins the maps of consecutive meshes, each given with its number of faces, into one map in the smallest layout.
    pub fn concat<'a>(maps: impl Iterator<Item = (&'a Self, usize)> + Clone) -> Result<Self> {
        let counts = || maps.clone().map(|(_, count)| count);
        let mut last = None;
        let runs = maps
            .clone()
            .zip(starts(counts()))
            .flat_map(|((map, count), first)| map.runs(count).map(move |(start, value)| (first + start, value)));
        let runs = runs.filter(|&(_, value)| last.replace(value) != Some(value));
        Self::from_runs(runs, counts().sum())
    }

    /// Converts to a smaller layout if the runs are long enough; otherwise keeps the `PerFace` array without a copy.
    pub fn compacted(self, face_count: usize) -> Result<Self> {
        let run_count = self.runs(face_count).take(face_count / FACES_PER_RUN + 2).count();
        if matches!(self, Self::PerFace(_)) && (run_count == 1 || run_count * FACES_PER_RUN <= face_count) {
            return Self::from_runs(self.runs(face_count), face_count);
        }
        Ok(self)
    }

    /// Returns the map of the given faces, in the given order.
    pub fn selected(&self, faces: &[u32], progress: &Progress) -> Result<Self> {
        let (starts, values) = match self {
            Self::Uniform(value) => return Ok(Self::Uniform(*value)),
            // Ascending faces need one binary search per range instead of one per face.
            Self::Ranges { starts, values } if faces.is_sorted() => (starts, values),
            _ => {
                let values = mapped(faces, |&face| self.get(face), progress)?;
                return Self::PerFace(values.into()).compacted(faces.len());
            }
        };
        let (mut runs, mut remaining): (Vec<(usize, i32)>, &[u32]) = (Vec::new(), faces);
        while let Some(&face) = remaining.first() {
            let next = starts.partition_point(|&start| start <= face);
            let value = values[next - 1];
            if runs.last().is_none_or(|&(_, last)| last != value) {
                runs.push((faces.len() - remaining.len(), value));
            }
            let end =
                starts.get(next).map_or(remaining.len(), |&start| remaining.partition_point(|&face| face < start));
            remaining = &remaining[end..];
        }
        progress.check()?;
        Self::from_runs(runs.into_iter(), faces.len())
    }

    /// Replaces each value v by `numbers[v]`; −1 and values beyond the end of `numbers` stay unchanged.
    pub(crate) fn renumbered(&self, numbers: &[i32]) -> Result<Self> {
        let number = |&value: &i32| by_number(numbers, value).copied().unwrap_or(value);
        let all = |values: &Buffer<i32>| try_list(values.iter().map(number)).map(Buffer::from);
        Ok(match self {
            Self::Uniform(value) => Self::Uniform(number(value)),
            Self::Ranges { starts, values } => Self::Ranges { starts: starts.clone(), values: all(values)? },
            Self::PerFace(values) => Self::PerFace(all(values)?),
        })
    }

    fn from_runs(runs: impl Iterator<Item = (usize, i32)>, face_count: usize) -> Result<Self> {
        let (mut starts, mut values) = (Vec::new(), Vec::new());
        for (start, value) in runs {
            try_push(&mut starts, start as u32)?;
            try_push(&mut values, value)?;
        }
        Ok(match values[..] {
            [] => Self::Uniform(-1),
            [value] => Self::Uniform(value),
            _ if starts.len() * FACES_PER_RUN <= face_count => {
                Self::Ranges { starts: starts.into(), values: values.into() }
            }
            _ => {
                let mut of_faces = try_with_capacity(face_count)?;
                let ends = starts[1..].iter().copied().chain([face_count as u32]);
                let lengths = starts.iter().zip(ends).map(|(start, end)| (end - start) as usize);
                of_faces.extend(values.iter().zip(lengths).flat_map(|(&value, n)| std::iter::repeat_n(value, n)));
                Self::PerFace(of_faces.into())
            }
        })
    }

    /// Checks that each of `face_count` faces has a value below `limit`.
    pub fn validate(&self, argument: &'static str, face_count: usize, limit: i32) -> Result<()> {
        let (values, is_well_formed) = match self {
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
        ensure!(is_well_formed, argument, format!("one value for each of {face_count} faces"), "another layout");
        match values.par_iter().with_min_len(1 << 16).find_any(|&&value| value < -1 || value >= limit) {
            Some(value) => Err(Error::value(argument, format!("numbers from -1 to {}", limit - 1), value)),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::collection::vec;
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn three_layouts_return_the_same() {
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

    fn values_of(map: &FaceMap, count: usize) -> Vec<i32> {
        (0..count as u32).map(|face| map.get(face)).collect()
    }

    proptest! {
        #[test]
        fn joining_compacting_and_selecting_keep_every_value(
            parts in vec(vec(prop_oneof![3 => Just(1), 1 => -1..4], 0..40), 0..6),
            picks in vec(0u32..10_000, 0..50),
        ) {
            let maps: Vec<FaceMap> = parts.iter().map(|part| FaceMap::PerFace(part.clone().into())).collect();
            let compact = maps.iter().zip(&parts).map(|(map, part)| map.clone().compacted(part.len()).unwrap()).collect::<Vec<_>>();
            let flat = parts.concat();
            for maps in [&maps, &compact] {
                let joined = FaceMap::concat(maps.iter().zip(parts.iter().map(Vec::len))).unwrap();
                prop_assert_eq!(values_of(&joined, flat.len()), flat.clone());
                prop_assert!(joined.validate("x", flat.len(), 4).is_ok());
                if !flat.is_empty() {
                    let picks: Vec<u32> = picks.iter().map(|pick| pick % flat.len() as u32).collect();
                    let expected: Vec<i32> = picks.iter().map(|&pick| flat[pick as usize]).collect();
                    prop_assert_eq!(values_of(&joined.selected(&picks, &Progress::new()).unwrap(), picks.len()), expected);
                    let mut sorted = picks;
                    sorted.sort_unstable();
                    let expected: Vec<i32> = sorted.iter().map(|&pick| flat[pick as usize]).collect();
                    let found = joined.selected(&sorted, &Progress::new()).unwrap();
                    prop_assert_eq!(values_of(&found, sorted.len()), expected);
                }
            }
        }
    }

    #[test]
    fn long_runs_become_ranges_and_short_ones_are_kept() {
        let long = FaceMap::PerFace((0..1000).map(|face| face / 100).collect()).compacted(1000).unwrap();
        assert!(matches!(long, FaceMap::Ranges { ref starts, .. } if starts.len() == 10));
        let short = FaceMap::PerFace((0..100).collect()).compacted(100).unwrap();
        assert!(matches!(short, FaceMap::PerFace(_)));
        assert!(matches!(FaceMap::PerFace(vec![3; 9].into()).compacted(9), Ok(FaceMap::Uniform(3))));
    }
}
