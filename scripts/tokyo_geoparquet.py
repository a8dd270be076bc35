"""Convert the outlines of Tokyo's buildings (PLATEAU 2020, CC BY 4.0) to GeoParquet, which other programs read, too.

    python scripts/tokyo_geoparquet.py IN.parquet OUT.parquet

The input stores corners as differences in decimetres; its metadata explain them. The output has a column of polygons in
WKB (EPSG:6677, metres) and one of heights, null where they are unknown.
"""

from __future__ import annotations

import argparse
import json

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
from numpy.typing import NDArray

_DECIMETRE = 0.1
_CRS = {
    "type": "ProjectedCRS",
    "name": "JGD2011 / Japan Plane Rectangular CS IX",
    "id": {"authority": "EPSG", "code": 6677},
}
_HEADER = np.frombuffer(b"\x01" + (3).to_bytes(4, "little"), np.uint8)
"""A polygon in little-endian WKB; the number of rings follows."""


def convert(source: str, target: str) -> None:
    """Write the GeoParquet."""
    with pq.ParquetFile(source) as file:
        metadata = {key.decode(): value.decode() for key, value in file.schema_arrow.metadata.items()}
        shift = np.array([float(metadata[f"origin_epsg6677_{axis}_m"]) for axis in "EN"])
        column = {"encoding": "WKB", "geometry_types": ["Polygon"], "crs": _CRS}
        geo = {"version": "1.1.0", "primary_column": "geometry", "columns": {"geometry": column}}
        schema = pa.schema([("geometry", pa.binary()), ("height", pa.float32())], {"geo": json.dumps(geo)})
        with pq.ParquetWriter(target, schema, compression="zstd") as writer:
            for group in range(file.num_row_groups):
                writer.write_table(_converted(file.read_row_group(group), shift).cast(schema))


def _converted(table: pa.Table, shift: NDArray[np.float64]) -> pa.Table:
    tenths = table["height_dm"].to_numpy()
    height = pa.array(np.round(tenths * _DECIMETRE, 1).astype(np.float32), mask=tenths == 0)
    rings = _flat(table, "ring_len").astype(np.int64)
    building_rings = _lengths(table, "ring_len")
    points = _corners(table) * _DECIMETRE + shift
    data, ends = polygons(points, rings, building_rings)
    geometry = pa.Array.from_buffers(pa.binary(), len(height), [None, pa.py_buffer(ends), pa.py_buffer(data)])
    return pa.table({"geometry": geometry, "height": height})


def _corners(table: pa.Table) -> NDArray[np.int64]:
    """Corners of all buildings in decimetres: the first one, and running sums of the differences."""
    counts = _lengths(table, "dx_dm")
    first = np.cumsum(counts) - counts
    corners = []
    for axis in "xy":
        total = np.cumsum(_flat(table, f"d{axis}_dm").astype(np.int64))
        before = np.concatenate([[0], total])[first]
        corners.append(total + (table[f"{axis}0_dm"].to_numpy() - before).repeat(counts))
    return np.stack(corners, axis=-1)


def polygons(
    points: NDArray[np.float64], ring_sizes: NDArray[np.int64], polygon_rings: NDArray[np.int64]
) -> tuple[NDArray[np.uint8], NDArray[np.int32]]:
    """WKB of polygons, one after the other, and their offsets. Rings end with their first point again."""
    ring_bytes = 4 + 16 * (ring_sizes + 1)
    last_ring = np.cumsum(polygon_rings)
    ring_ends = np.concatenate([[0], np.cumsum(ring_bytes)])
    heads = 9 * np.arange(1, len(polygon_rings) + 1)
    ends = np.concatenate([[0], ring_ends[last_ring] + heads])
    data = np.zeros(int(ends[-1]), np.uint8)
    for byte, value in enumerate(_HEADER):
        data[ends[:-1] + byte] = value
    _put(data, ends[:-1] + 5, polygon_rings.astype("<u4"))
    ring_starts = ring_ends[:-1] + heads.repeat(polygon_rings)
    _put(data, ring_starts, (ring_sizes + 1).astype("<u4"))
    point_ends = np.cumsum(ring_sizes)
    rows = np.arange(len(points)) - (point_ends - ring_sizes).repeat(ring_sizes)
    _put(data, ring_starts.repeat(ring_sizes) + 4 + 16 * rows, points.astype("<f8"))
    _put(data, ring_starts + 4 + 16 * ring_sizes, points[point_ends - ring_sizes].astype("<f8"))
    return data, ends.astype(np.int32)


def _put(data: NDArray[np.uint8], places: NDArray[np.int64], rows: NDArray[np.generic]) -> None:
    """Write the bytes of rows at places of their own."""
    values = np.ascontiguousarray(rows).view(np.uint8).reshape(len(places), -1)
    for byte in range(values.shape[1]):
        data[places + byte] = values[:, byte]


def _flat(table: pa.Table, name: str) -> NDArray[np.int64]:
    return np.asarray(table[name].combine_chunks().flatten().to_numpy())


def _lengths(table: pa.Table, name: str) -> NDArray[np.int64]:
    return np.asarray(table[name].combine_chunks().value_lengths().to_numpy().astype(np.int64))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source")
    parser.add_argument("target")
    arguments = parser.parse_args()
    convert(arguments.source, arguments.target)
