"""Reads footprints from GeoParquet 1.x: a column of WKB, and columns of properties."""

from __future__ import annotations

import json
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._base.errors import SceneError, UnusableError
from nearfar._scene.budget import Budget
from nearfar._scene.city import crs, heights
from nearfar._scene.city.outlines import Outlines, Table, concatenate

_BATCH = 1 << 16
"""Number of rows decoded at once."""

_POINT_BYTES = 16
_FEATURE_BYTES = 96
"""Bytes of a feature's offset, heights and box."""

_EXPECTED = (
    "expected GeoParquet of footprints: the metadata 'geo', a column of WKB geometries that it names, and numbers in a "
    "column such as height, or in the one that height='NAME' names"
)
"""Columns that a file needs."""


def read(data: bytes, budget: Budget) -> Table:
    """Read the features of a file; the budget counts the unpacked bytes."""
    if not find_spec("pyarrow"):
        raise UnusableError('it is GeoParquet, which the Python package pyarrow reads: pip install "nearfar[formats]"')
    import pyarrow as pa
    import pyarrow.parquet as pq

    try:
        file = pq.ParquetFile(pa.BufferReader(data))
        try:
            name, column = _geometry(file.schema_arrow.metadata or {})
            if name not in file.schema_arrow.names:
                raise UnusableError(f"its metadata 'geo' names the column {check.shortened(name)}, which it lacks")
            _check_bytes(file.schema_arrow.field(name).type)
        except UnusableError as error:
            columns_text = check.shortened(", ".join(file.schema_arrow.names))
            raise UnusableError(f"{error}; {_EXPECTED}, got the columns {columns_text}") from None
        outlines, skipped = _outlines(file, name, budget)
        columns = _Columns(file)
    except (pa.ArrowException, OSError) as error:
        raise UnusableError(f"it is not a Parquet file, or it is damaged: {check.one_line(str(error), 120)}") from None
    system, degrees, metres = crs.parse_projjson(column["crs"]) if "crs" in column else ("WGS84", True, 1.0)
    note = () if column.get("crs", "") is not None else ("no coordinate system stated, taken as metres",)
    return Table(outlines, system, degrees, columns, metres, skipped, note, "GeoParquet")


def _geometry(metadata: dict[bytes, bytes]) -> tuple[str, dict[str, Any]]:
    """Name of the primary geometry column, and its metadata."""
    if b"geo" not in metadata:
        raise UnusableError("it lacks the metadata 'geo' of a GeoParquet file")
    try:
        geo = json.loads(metadata[b"geo"])
    except ValueError:
        raise UnusableError("its metadata 'geo' is not JSON") from None
    name = geo.get("primary_column") if isinstance(geo, dict) else None
    columns = geo.get("columns") if isinstance(geo, dict) else None
    column = columns.get(name) if isinstance(columns, dict) and isinstance(name, str) else None
    if not isinstance(name, str) or not isinstance(column, dict):
        raise UnusableError("its metadata 'geo' describes no primary column")
    if column.get("encoding") != "WKB":
        raise UnusableError(f"its geometry is encoded as {check.shortened(column.get('encoding'))}, and WKB is read")
    return name, column


def _outlines(file: Any, name: str, budget: Budget) -> tuple[Outlines, int]:
    parts, skipped, row_count = [], 0, 0
    for batch in file.iter_batches(_BATCH, columns=[name]):
        outlines, skipped_in_batch = _batch(batch.column(0), row_count)
        row_count += batch.num_rows
        skipped += skipped_in_batch
        # A page of equal rows compresses to a few bytes, whatever its number of rows.
        budget.count_arrays(len(outlines.points) * _POINT_BYTES + batch.num_rows * _FEATURE_BYTES)
        parts.append(outlines)
    return concatenate(parts), skipped


def _check_bytes(kind: Any) -> None:
    """Raise UnusableError unless a geometry column of this type holds bytes."""
    import pyarrow as pa

    if not (pa.types.is_binary(kind) or pa.types.is_large_binary(kind)):
        raise UnusableError(f"its geometry column holds {kind}, not bytes")


def _batch(column: Any, first_row: int) -> tuple[Outlines, int]:
    import pyarrow as pa

    rows = column.fill_null(b"").cast(pa.large_binary())
    _, ends, values = rows.buffers()
    bounds = np.frombuffer(ends, np.int64)[rows.offset : rows.offset + len(rows) + 1]
    bounds = bounds if len(bounds) else np.zeros(1, np.int64)
    data = np.frombuffer(values or b"", np.uint8)[bounds[0] : bounds[-1]]
    try:
        points, rings, polygons, features, skipped = _core.read_wkb(data, bounds - bounds[0])
    except SceneError as error:
        words = str(error).split(" ", 2)
        message = f"row {first_row + int(words[1].rstrip(':'))}: {words[2]}" if len(words) == 3 else str(error)
        raise UnusableError(f"geometry of {message}") from None
    return Outlines(points, rings, polygons, features), skipped


class _Columns:
    """Columns of a file, read on demand."""

    def __init__(self, file: Any) -> None:
        self._file = file

    def __call__(self, name: str) -> NDArray[np.float64] | None:
        import pyarrow as pa

        column = self._column(name)
        if column is None:
            return None
        if pa.types.is_integer(column.type) or pa.types.is_floating(column.type):
            return column.cast(pa.float64(), safe=False).to_numpy()  # type: ignore[no-any-return]
        return heights.numbers(column.to_pylist()) if pa.types.is_string(column.type) else None

    def texts(self, name: str | None) -> list[str] | None:
        import pyarrow as pa

        column = self._column(name or "id")
        if column is None or column.null_count:
            return None
        is_name = pa.types.is_string(column.type) or pa.types.is_large_string(column.type)
        return [str(value) for value in column.to_pylist()] if is_name or pa.types.is_integer(column.type) else None

    def _column(self, name: str) -> Any:
        return self._file.read(columns=[name]).column(0) if name in self._file.schema_arrow.names else None
