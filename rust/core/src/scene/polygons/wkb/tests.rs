use proptest::prelude::*;

use super::*;

type Rings = Vec<Vec<[f64; 2]>>;

/// Encoding of geometries by a writer.
#[derive(Debug, Clone, Copy)]
struct Style {
    is_little: bool,
    columns: usize,
    /// Whether types use the flags of PostGIS instead of ISO's numbers.
    is_flagged: bool,
}

const PLAIN: Style = Style { is_little: true, columns: 2, is_flagged: false };

impl Style {
    fn number(self, value: u32) -> Vec<u8> {
        (if self.is_little { value.to_le_bytes() } else { value.to_be_bytes() }).to_vec()
    }

    fn header(self, kind: u32) -> Vec<u8> {
        let stated = match (self.is_flagged, self.columns) {
            (_, 2) => kind,
            (false, columns) => kind + [1000, 3000][columns - 3],
            (true, columns) => kind | HAS_Z | HAS_SRID | if columns == 4 { HAS_M } else { 0 },
        };
        let id = if stated & HAS_SRID == 0 { vec![] } else { self.number(4326) };
        [vec![u8::from(self.is_little)], self.number(stated), id].concat()
    }

    fn run(self, points: &[[f64; 2]]) -> Vec<u8> {
        let mut bytes = self.number(points.len() as u32);
        for point in points {
            let row = [point[0], point[1], 7.0, 8.0];
            for value in &row[..self.columns] {
                bytes.extend(if self.is_little { value.to_le_bytes() } else { value.to_be_bytes() });
            }
        }
        bytes
    }

    fn polygon(self, rings: &[Vec<[f64; 2]>]) -> Vec<u8> {
        let closed = rings.iter().flat_map(|ring| {
            let last = ring.first().copied();
            self.run(&ring.iter().copied().chain(last).collect::<Vec<_>>())
        });
        [self.header(3), self.number(rings.len() as u32), closed.collect()].concat()
    }

    fn collection(self, kind: u32, parts: &[Vec<u8>]) -> Vec<u8> {
        [self.header(kind), self.number(parts.len() as u32), parts.concat()].concat()
    }
}

fn read_rows(rows: &[Vec<u8>]) -> Result<Outlines> {
    let mut offsets = vec![0];
    for row in rows {
        offsets.push(offsets[offsets.len() - 1] + row.len() as i64);
    }
    read(&rows.concat(), &offsets, &Progress::new())
}

/// Returns the rings of each polygon of each row.
fn polygon_lists(found: &Outlines) -> Vec<Vec<Rings>> {
    let range = |offsets: &[i64], n: usize| offsets[n] as usize..offsets[n + 1] as usize;
    let ring = |n: usize| found.points[range(&found.rings, n)].to_vec();
    let polygon = |n: usize| range(&found.polygons, n).map(ring).collect();
    (0..found.rows.len() - 1).map(|n| range(&found.rows, n).map(polygon).collect()).collect()
}

fn triangle(x: f64) -> Vec<[f64; 2]> {
    vec![[x, 0.0], [x + 1.0, 0.5], [x, 1.0]]
}

#[test]
fn every_layout_is_read() {
    for is_little in [false, true] {
        for (columns, is_flagged) in [(2, false), (3, false), (4, false), (3, true), (4, true)] {
            let style = Style { is_little, columns, is_flagged };
            let (one, two): (Rings, Rings) = (vec![triangle(0.0), triangle(9.0)], vec![triangle(-1e7)]);
            let several = style.collection(6, &[style.polygon(&one), style.polygon(&two)]);
            let rows = [style.polygon(&two), vec![], several.clone(), style.collection(7, &[several])];
            let found = read_rows(&rows).unwrap();
            let both = vec![one, two.clone()];
            assert_eq!(polygon_lists(&found), [vec![two], vec![], both.clone(), both], "{style:?}");
            assert_eq!(found.skipped, 0);
        }
    }
}

#[test]
fn points_and_lines_are_counted() {
    let line = [PLAIN.header(2), PLAIN.run(&triangle(0.0))].concat();
    let point = [PLAIN.header(1), vec![0; 16]].concat();
    let rows = [line.clone(), PLAIN.collection(5, &[line.clone(), line.clone()]), PLAIN.collection(7, &[point, line])];
    let found = read_rows(&rows).unwrap();
    assert_eq!((found.skipped, polygon_lists(&found)), (5, vec![vec![], vec![], vec![]]));
}

#[test]
fn rows_of_several_tasks_stay_in_order() {
    let count = ROWS_PER_TASK + 3;
    let rows: Vec<_> = (0..count).map(|n| PLAIN.polygon(&[triangle(n as f64)])).collect();
    let found = read_rows(&rows).unwrap();
    let expected: Vec<Vec<Rings>> = (0..count).map(|n| vec![vec![triangle(n as f64)]]).collect();
    assert_eq!(polygon_lists(&found), expected);
}

#[test]
fn flaws_name_the_first_row_that_has_one() {
    let good = PLAIN.polygon(&[triangle(0.0)]);
    let many = u32::MAX.to_le_bytes();
    let mut nested = good.clone();
    for _ in 0..=MAX_DEPTH {
        nested = PLAIN.collection(7, &[nested]);
    }
    for (row, words) in [
        (good[..good.len() - 1].to_vec(), "it claims 4 parts, more than its bytes can hold"),
        ([&good[..], &[0]].concat(), "1 bytes follow its geometry"),
        (vec![2, 3, 0, 0, 0], "its byte order is 2, not 0 or 1"),
        (vec![1, 3, 0, 0], "it is cut off"),
        (vec![1], "it is cut off"),
        ([PLAIN.header(1), vec![0; 15]].concat(), "it is cut off"),
        ([&PLAIN.header(3)[..], &many].concat(), "it claims 4294967295 parts, more than its bytes can hold"),
        ([&PLAIN.header(7)[..], &many].concat(), "it claims 4294967295 parts, more than its bytes can hold"),
        (PLAIN.header(16), "geometry type 16 is not read, only points, lines and polygons are"),
        (PLAIN.header(4003), "geometry type 4003 is not known"),
        (nested, "its geometries are nested deeper than 16"),
    ] {
        let rows = [good.clone(), row.clone(), vec![9]];
        assert_eq!(read_rows(&rows), Err(Error::Scene(format!("row 1: {words}"))), "{row:?}");
    }
    assert!(matches!(read(&good, &[0, 3], &Progress::new()), Err(Error::Value { argument: "offsets", .. })));
}

proptest! {
    #[test]
    fn any_bytes_are_polygons_or_an_error(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        let _ = read_rows(&[bytes]);
    }

    #[test]
    fn damaged_rows_are_polygons_or_an_error(at in 0..200usize, byte: u8) {
        let inner = Style { is_little: false, ..PLAIN };
        let mut row = PLAIN.collection(6, &[PLAIN.polygon(&[triangle(0.0), triangle(2.0)]), inner.polygon(&[triangle(5.0)])]);
        let at = at % row.len();
        row[at] = byte;
        if let Ok(found) = read_rows(&[row.clone()]) {
            prop_assert!(found.points.len() * 16 <= row.len());
            prop_assert_eq!(found.rows.len(), 2);
        }
    }
}
