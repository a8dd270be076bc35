//! Reader for Wavefront OBJ text, in one pass over its lines.

use std::borrow::Cow;
use std::collections::HashMap;

use glam::DVec3;
use rayon::prelude::*;

use super::polygons::{FaceClipper, Fans, fan_covers};
use crate::base::mapped::{filtered, mapped};
use crate::base::memory::{try_append, try_copy, try_extend, try_list, try_push};
use crate::base::sort::sort_by_key;
use crate::base::{Error, Progress, Result};

/// Marks a texture coordinate or normal that a corner does not have.
pub const NONE: u32 = u32::MAX;

/// Maximum characters of a word quoted in a message.
const MAX_QUOTED: usize = 60;

/// Kinds of rows, in the order of indices in a face's corner.
const KINDS: [&str; 3] = ["vertex", "texture coordinate", "normal"];
/// Lines between two checks for cancellation.
const LINES_PER_CHECK: u64 = 1 << 12;

/// Content of an OBJ file.
#[derive(Debug, Default, PartialEq)]
pub struct Wavefront {
    /// Positions of vertices.
    pub positions: Vec<[f64; 3]>,
    /// Colours of vertices; empty unless all vertices have one.
    pub colors: Vec<[f64; 3]>,
    /// Texture coordinates.
    pub uvs: Vec<[f64; 2]>,
    /// Normals.
    pub normals: Vec<[f64; 3]>,
    /// Names of material library files.
    pub libraries: Vec<String>,
    /// Names of objects and materials.
    pub names: Vec<String>,
    /// Faces by object and material, in order of first appearance.
    pub parts: Vec<Part>,
    /// Numbers of skipped elements.
    pub skipped: Skipped,
    /// Numbers of polygons that are fans although these do not cover them.
    pub fans: Fans,
}

/// Numbers of elements without triangles.
#[derive(Debug, Default, PartialEq)]
pub struct Skipped {
    /// Faces with fewer than three corners.
    pub faces: u64,
    /// Statements of lines.
    pub lines: u64,
    /// Statements of points.
    pub points: u64,
    /// Free-form curves and surfaces.
    pub free_forms: u64,
}

/// Faces of one object with one material.
#[derive(Debug, Default, PartialEq)]
pub struct Part {
    /// Index of the object's name. Parts share names, which may be long.
    pub object: Option<u32>,
    /// Index of the material's name.
    pub material: Option<u32>,
    /// Indices of each vertex's position, texture coordinate and normal; `NONE` for a missing one.
    pub vertices: Vec<[u32; 3]>,
    /// Triangles between these vertices.
    pub faces: Vec<[u32; 3]>,
}

/// Reads a text. Polygons, which may be concave, are triangulated. Indices may refer to later rows; an index out of
/// range is an error that names its line.
pub fn read(text: &[u8], progress: &Progress) -> Result<Wavefront> {
    let mut scan = Scan::default();
    let (mut start, mut line) = (0, 1);
    let mut next_check = LINES_PER_CHECK;
    while start < text.len() {
        let (end, lines) = logical_end(text, start);
        scan.line(&text[start..end], line)?;
        (start, line) = (end + 1, line + lines);
        if line >= next_check {
            progress.check()?;
            next_check = line + LINES_PER_CHECK;
        }
    }
    scan.finish(progress)
}

#[derive(Default)]
struct Scan {
    content: Wavefront,
    /// Largest index of each kind, and its line.
    max_index: [(u64, u64); 3],
    /// Whether a vertex had no colour.
    lacks_color: bool,
    names: HashMap<Vec<u8>, u32>,
    object: Option<u32>,
    material: Option<u32>,
    /// Index of the part with a given object and material.
    numbers: HashMap<(Option<u32>, Option<u32>), usize>,
    /// Index of the part that faces are added to; `None` after a change of object or material.
    part: Option<usize>,
    faces: Vec<PartFaces>,
}

/// Faces of one part.
#[derive(Default)]
struct PartFaces {
    /// Three corners for each triangle; polygons are fans.
    corners: Vec<[u32; 3]>,
    /// Polygons of more than three corners: index of the first corner in `corners`, and number of corners.
    polygons: Vec<(usize, usize)>,
}

impl Scan {
    fn line(&mut self, text: &[u8], line: u64) -> Result<()> {
        let trimmed = text.trim_ascii_start();
        let length =
            trimmed.iter().position(|byte| byte.is_ascii_whitespace() || *byte == b'\\').unwrap_or(trimmed.len());
        let (keyword, remainder) = trimmed.split_at(length);
        if !matches!(keyword, b"v" | b"vt" | b"vn" | b"f" | b"o" | b"usemtl" | b"mtllib") {
            let skipped = &mut self.content.skipped;
            match keyword {
                b"l" => skipped.lines += 1,
                b"p" => skipped.points += 1,
                b"curv" | b"curv2" | b"surf" => skipped.free_forms += 1,
                _ => {}
            }
            return Ok(());
        }
        let remainder = if remainder.contains(&b'\n') {
            Cow::Owned(join_continued_line(remainder))
        } else {
            Cow::Borrowed(remainder)
        };
        let arguments = remainder.split(|&byte| byte == b'#').next().unwrap_or_default();
        match keyword {
            b"v" => self.vertex(arguments, line)?,
            b"vt" => {
                let (_, [u, v, ..]) = numbers(arguments, 1, line, "texture coordinate")?;
                try_push(&mut self.content.uvs, [u, v])?;
            }
            b"vn" => {
                let (_, [x, y, z, ..]) = numbers(arguments, 3, line, "normal")?;
                try_push(&mut self.content.normals, [x, y, z])?;
            }
            b"f" => self.face(arguments, line)?,
            b"o" => self.object = self.number_of_name(remainder.trim_ascii()),
            b"usemtl" => self.material = self.number_of_name(remainder.trim_ascii()),
            _ => self.content.libraries.push(String::from_utf8_lossy(remainder.trim_ascii()).into_owned()),
        }
        Ok(())
    }

    fn vertex(&mut self, arguments: &[u8], line: u64) -> Result<()> {
        let (count, [x, y, z, color @ ..]) = numbers(arguments, 3, line, "vertex")?;
        try_push(&mut self.content.positions, [x, y, z])?;
        self.lacks_color |= count < 6;
        if self.lacks_color {
            self.content.colors = Vec::new();
        } else {
            try_push(&mut self.content.colors, color)?;
        }
        Ok(())
    }

    /// Returns the number of a name and starts a new part.
    fn number_of_name(&mut self, name: &[u8]) -> Option<u32> {
        self.part = None;
        let next = self.names.len() as u32;
        Some(*self.names.entry(name.to_vec()).or_insert(next))
    }

    /// Parses a face: corners of one to three indices.
    fn face(&mut self, arguments: &[u8], line: u64) -> Result<()> {
        let key = (self.object, self.material);
        let part = match self.part {
            Some(part) => part,
            None => *self.numbers.entry(key).or_insert_with(|| {
                self.faces.push(PartFaces::default());
                self.faces.len() - 1
            }),
        };
        self.part = Some(part);
        let start = self.faces[part].corners.len();
        let (mut first, mut last, mut count) = ([NONE; 3], [NONE; 3], 0);
        let words = arguments.split(u8::is_ascii_whitespace).filter(|corner| !corner.is_empty());
        for word in words {
            let corner = self.corner(word, line)?;
            match count {
                0 => first = corner,
                1 => {}
                _ => try_append(&mut self.faces[part].corners, &[first, last, corner])?,
            }
            last = corner;
            count += 1;
        }
        self.content.skipped.faces += u64::from(count < 3);
        if count > 3 {
            try_push(&mut self.faces[part].polygons, (start, count))?;
        }
        Ok(())
    }

    fn corner(&mut self, word: &[u8], line: u64) -> Result<[u32; 3]> {
        let mut corner = [NONE; 3];
        for (kind, index) in word.split(|&byte| byte == b'/').enumerate() {
            if kind >= KINDS.len() {
                let word = shorten(word);
                return Err(Error::Scene(format!("line {line}: '{word}' has more than three indices")));
            }
            if index.is_empty() && kind > 0 {
                continue;
            }
            let index = self.absolute(index, kind, line)?;
            if index > self.max_index[kind].0 {
                self.max_index[kind] = (index, line);
            }
            // An index that does not fit counts as out of range; `finish` reports it.
            corner[kind] = u32::try_from(index - 1).unwrap_or(NONE);
        }
        Ok(corner)
    }

    /// Parses an index and returns it counted from 1; negative indices count back from the last row so far.
    fn absolute(&self, index: &[u8], kind: usize, line: u64) -> Result<u64> {
        let (digits, is_negative) = match index {
            [b'-', digits @ ..] => (digits, true),
            [b'+', digits @ ..] | digits => (digits, false),
        };
        let word = || shorten(index);
        if digits.is_empty() || !digits.iter().all(u8::is_ascii_digit) {
            return Err(Error::Scene(format!("line {line}: a face has '{}' where an index belongs", word())));
        }
        let value =
            digits.iter().fold(0u64, |value, digit| value.saturating_mul(10).saturating_add(u64::from(digit - b'0')));
        let count = self.counts()[kind];
        match (value, is_negative) {
            (0, _) => Err(Error::Scene(format!("line {line}: a face names {} 0, but the first is 1", KINDS[kind]))),
            (value, true) if value > count => Err(out_of_range(line, KINDS[kind], &word(), count)),
            (value, true) => Ok(count + 1 - value),
            (value, false) => Ok(value),
        }
    }

    /// Returns the number of vertices, texture coordinates and normals so far.
    fn counts(&self) -> [u64; 3] {
        [self.content.positions.len(), self.content.uvs.len(), self.content.normals.len()].map(|count| count as u64)
    }

    fn finish(self, progress: &Progress) -> Result<Wavefront> {
        for ((kind, count), (index, line)) in KINDS.iter().zip(self.counts()).zip(self.max_index) {
            if index > count {
                return Err(out_of_range(line, kind, &index.to_string(), count));
            }
            if count >= u64::from(NONE) {
                return Err(Error::Scene(format!("expected fewer than {NONE} lines of one kind, got {count}")));
            }
        }
        let mut content = self.content;
        content.names = vec![String::new(); self.names.len()];
        for (name, number) in self.names {
            content.names[number as usize] = String::from_utf8_lossy(&name).into_owned();
        }
        let mut keys = vec![(None, None); self.faces.len()];
        for (key, number) in self.numbers {
            keys[number] = key;
        }
        // A lone part without texture coordinates and normals keeps all vertices in their order, including unused ones.
        let is_plain = self.faces.len() == 1 && content.uvs.is_empty() && content.normals.is_empty();
        let count = content.positions.len() as u32;
        let positions = &content.positions;
        let parts = self.faces.into_par_iter().zip(keys).map(|(faces, (object, material))| {
            let (corners, fans) = faces.triangles(positions, progress)?;
            let [vertices, faces] = if is_plain {
                let faces = mapped(corners.as_chunks::<3>().0, |face| face.map(|corner| corner[0]), progress)?;
                [try_list((0..count).map(|vertex| [vertex, NONE, NONE]))?, faces]
            } else {
                deduplicate(&corners, progress)?
            };
            Ok((Part { object, material, vertices, faces }, fans))
        });
        let parts: Vec<(Part, Fans)> = parts.collect::<Result<_>>()?;
        for (part, fans) in parts {
            content.parts.push(part);
            content.fans.large += fans.large;
            content.fans.crossing += fans.crossing;
        }
        Ok(content)
    }
}

impl PartFaces {
    /// Returns three corners for each triangle; polygons that their fans do not cover are triangulated anew.
    fn triangles(self, positions: &[[f64; 3]], progress: &Progress) -> Result<(Vec<[u32; 3]>, Fans)> {
        let Self { corners, polygons } = self;
        // Each triangle of a fan ends with the next corner.
        let corner = |start: usize, n: usize| if n < 2 { corners[start + n] } else { corners[start + 3 * n - 4] };
        let corner = &corner;
        let points = |(start, count): (usize, usize)| {
            (0..count).map(move |n| DVec3::from(positions[corner(start, n)[0] as usize]))
        };
        let is_wrong = |polygon: u32| !fan_covers(points(polygons[polygon as usize]));
        let wrong = filtered(polygons.len() as u32, is_wrong, progress)?;
        let (mut clipper, mut triangles, mut copied, mut fans) =
            (FaceClipper::default(), Vec::new(), 0, Fans::default());
        for polygon in wrong {
            progress.check()?;
            let (start, count) = polygons[polygon as usize];
            match clipper.clip(points((start, count))) {
                Ok(faces) => {
                    try_append(&mut triangles, &corners[copied..start])?;
                    try_extend(&mut triangles, faces.as_flattened().iter().map(|&n| corner(start, n as usize)))?;
                    copied = start + 3 * (count - 2);
                }
                Err(reason) => fans.count(reason),
            }
        }
        if copied == 0 {
            return Ok((corners, fans));
        }
        try_append(&mut triangles, &corners[copied..])?;
        Ok((triangles, fans))
    }
}

/// Deduplicates corners; returns sorted unique vertices, and triangles between them.
fn deduplicate(corners: &[[u32; 3]], progress: &Progress) -> Result<[Vec<[u32; 3]>; 2]> {
    let mut vertices = try_copy(corners)?;
    sort_by_key(&mut vertices, |&corner| corner, progress)?;
    vertices.dedup();
    let place = |corner: [u32; 3]| vertices.partition_point(|&other| other < corner) as u32;
    let faces = mapped(corners.as_chunks::<3>().0, |face| face.map(place), progress)?;
    Ok([vertices, faces])
}

fn out_of_range(line: u64, kind: &str, index: &str, count: u64) -> Error {
    Error::Scene(format!("line {line}: a face names {kind} {index}, but there are {count}"))
}

fn shorten(word: &[u8]) -> String {
    let text = String::from_utf8_lossy(word);
    match text.char_indices().nth(MAX_QUOTED) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.into_owned(),
    }
}

/// Parses up to six numbers of a line, at least `min_count`; returns their count and the values, padded with zeros.
fn numbers(arguments: &[u8], min_count: usize, line: u64, kind: &str) -> Result<(usize, [f64; 6])> {
    let (mut values, mut count) = ([0.0; 6], 0);
    let words = arguments.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    for (value, word) in values.iter_mut().zip(words) {
        let parsed = str::from_utf8(word).ok().and_then(|word| word.parse().ok());
        *value = parsed.ok_or_else(|| {
            let word = shorten(word);
            Error::Scene(format!("line {line}: a {kind} has '{word}' where a number belongs"))
        })?;
        count += 1;
    }
    if count < min_count {
        return Err(Error::Scene(format!("line {line}: a {kind} has {count} numbers, but needs {min_count}")));
    }
    Ok((count, values))
}

/// Joins a continued line: replaces its line breaks and the backslashes before them by spaces.
fn join_continued_line(line: &[u8]) -> Vec<u8> {
    let ends = |index: usize| matches!(line[index..], [b'\\', b'\n', ..] | [b'\\', b'\r', b'\n', ..] | [b'\n', ..]);
    line.iter().enumerate().map(|(index, &byte)| if ends(index) { b' ' } else { byte }).collect()
}

/// Returns the end of the logical line that begins at `start`, without line feed, and its number of text lines.
fn logical_end(text: &[u8], start: usize) -> (usize, u64) {
    let (mut line_start, mut lines) = (start, 1);
    loop {
        let end = text[line_start..].iter().position(|&byte| byte == b'\n').map_or(text.len(), |n| line_start + n);
        if end == text.len() || !matches!(text[start..end], [.., b'\\'] | [.., b'\\', b'\r']) {
            return (end, lines);
        }
        (line_start, lines) = (end + 1, lines + 1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n";

    fn read_text(text: &str) -> Result<Wavefront> {
        read(text.as_bytes(), &Progress::new())
    }

    /// Returns the triangles of all parts as indices of their corners, counted from 1; 0 for none.
    fn corners(faces: &str) -> Vec<[[u32; 3]; 3]> {
        let read = read_text(&format!("{CORNERS}{faces}")).unwrap();
        let corner = |part: &Part, vertex: u32| part.vertices[vertex as usize].map(|row| row.wrapping_add(1));
        read.parts
            .iter()
            .flat_map(|part| part.faces.iter().map(|face| face.map(|vertex| corner(part, vertex))))
            .collect()
    }

    #[test]
    fn indices_count_from_one_and_back_from_the_last() {
        assert_eq!(corners("f 1 2//1 3"), [[[1, 0, 0], [2, 0, 1], [3, 0, 0]]]);
        let expected = [[[1, 0, 0], [2, 0, 0], [3, 0, 0]], [[4, 0, 0], [1, 0, 1], [2, 0, 0]]];
        assert_eq!(corners("f -3 -2 -1\nv 5 5 5\nf -1 1//-1 +2\n"), expected);
        assert_eq!(corners("f 4 2 3 # ends\nv 5 5 5"), [[[4, 0, 0], [2, 0, 0], [3, 0, 0]]]);
    }

    #[test]
    fn no_line_is_missed() {
        let face = [[1, 0, 0], [2, 0, 0], [3, 0, 0]];
        assert_eq!(corners(" f 1 2 3\n\tf\t1  2 3 \r\n"), [face, face]);
        // The fourth corner is at the place of the first.
        let turned = [[3, 0, 0], [1, 0, 0], [2, 0, 0]];
        assert_eq!(corners("f 1 2\\\n3\\\r\n 1\r\nf 1 \\\n2 3"), [turned, face]);
        assert_eq!(corners("v\t1 2 \\\n 3\n  o  a \nf 4 1 2"), [[[4, 0, 0], [1, 0, 0], [2, 0, 0]]]);
        assert_eq!(corners("# f 0\nfoo 0\n\\\nf 1 2\nl 1 2\nusemtl \n\ng\n"), [[[0; 3]; 3]; 0]);
        let skipped = Skipped { faces: 2, lines: 1, points: 2, free_forms: 1 };
        let text = format!("{CORNERS}f 1 2\nf\nl 1 2 3\np 1\np 2 3\nsurf 0 1 0 1 1\n");
        assert_eq!(read_text(&text).unwrap().skipped, skipped);
    }

    #[test]
    fn faces_are_grouped_by_object_and_material() {
        let text = "f 1 2 3\no a\nusemtl m\nf 1 2 3\no b b \nf 3 2 1\nusemtl n\no a\nusemtl m\nf 2 3 1\nmtllib x y.mtl";
        let read = read_text(&format!("{CORNERS}{text}")).unwrap();
        let name = |number: Option<u32>| number.map_or("", |number| &read.names[number as usize]);
        let named = |part: &Part| (name(part.object), name(part.material), part.faces.len());
        let expected = [("", "", 1), ("a", "m", 2), ("b b", "m", 1)];
        assert_eq!(read.parts.iter().map(named).collect::<Vec<_>>(), expected);
        assert_eq!(read.libraries, ["x y.mtl"]);
    }

    #[test]
    fn concave_faces_have_their_area_and_corners_keep_their_rows() {
        // A dart of area 1 between two triangles; its vertices come later.
        for first in 0..4 {
            let mut dart = ["1/4", "2/3", "3/2", "4/1"];
            dart.rotate_left(first);
            let rows = "v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nvt 0.1\nvt 0.2\nvt 0.3\nvt 0.4\n";
            let read = read_text(&format!("f 1/1 2/1 3/1\nf {}\nf 3/1 2/1 1/1\n{rows}", dart.join(" "))).unwrap();
            let [part] = &read.parts[..] else { panic!() };
            let corner = |vertex: &u32| part.vertices[*vertex as usize];
            assert_eq!(part.faces.len(), 4);
            let dart = part.faces[1..3].as_flattened();
            assert!(dart.iter().map(corner).all(|[position, uv, _]| position + uv == 3));
            let area = |face: &[u32]| {
                let [a, b, c] = [0, 1, 2].map(|n| DVec3::from(read.positions[corner(&face[n])[0] as usize]));
                (b - a).cross(c - a).z / 2.0
            };
            assert_eq!(dart.chunks(3).map(area).collect::<Vec<_>>(), [0.5, 0.5]);
        }
    }

    #[test]
    fn colours_count_where_all_vertices_have_one() {
        assert_eq!(
            read_text("v 0 0 0 1 0.5 0\nv 1 0 0 0 0 1e-1 7").unwrap().colors,
            [[1.0, 0.5, 0.0], [0.0, 0.0, 0.1]]
        );
        assert_eq!(read_text("v 0 0 0 1 0.5 0\nv 1 0 0\nv 0 0 0 1 0.5 0").unwrap().colors, [[0.0; 3]; 0]);
    }

    #[test]
    fn out_of_range_indices_are_errors() {
        for (faces, words) in [
            ("f 0 1 2", "line 5: a face names vertex 0, but the first is 1"),
            ("\nf 1 2 3\nf 1 2 4\n", "line 7: a face names vertex 4, but there are 3"),
            ("f -4 1 2", "line 5: a face names vertex -4, but there are 3"),
            ("f 1//9 2 3", "line 5: a face names normal 9, but there are 1"),
            ("f 1/1 2/1 3/1", "line 5: a face names texture coordinate 1, but there are 0"),
            ("f 1 \\\n2\\\n3\nf 1 2 x", "line 8: a face has 'x' where an index belongs"),
            ("f 1.0 2 3", "line 5: a face has '1.0' where an index belongs"),
            ("f /1 2 3", "line 5: a face has '' where an index belongs"),
            ("f 1/1/1/1 2 3", "line 5: '1/1/1/1' has more than three indices"),
            ("f 99999999999999999999999 2 3", "line 5: a face names vertex 18446744073709551615, but there are 3"),
            ("f - 2 3", "line 5: a face has '-' where an index belongs"),
            (
                &format!("f {} 2 3", "é".repeat(99)),
                &format!("line 5: a face has '{}…' where an index belongs", "é".repeat(60)),
            ),
            ("v 1 2", "line 5: a vertex has 2 numbers, but needs 3"),
            ("vn 1 2 0x3", "line 5: a normal has '0x3' where a number belongs"),
            ("vt", "line 5: a texture coordinate has 0 numbers, but needs 1"),
        ] {
            assert_eq!(read_text(&format!("{CORNERS}{faces}")), Err(Error::Scene(words.to_owned())), "{faces:?}");
        }
    }
}
