"""Extrudes footprints of buildings by their heights: all of a file, or those that touch a box."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._scene.arrays import origin_for, touching
from nearfar._scene.city import heights
from nearfar._scene.city.collector import CROSSING
from nearfar._scene.city.crs import Geodetic, Georeference, Projected
from nearfar._scene.city.outlines import Table
from nearfar._scene.content import Content, Nodes, Shape, translation
from nearfar._scene.frames import checked_origin
from nearfar._scene.names import distinct
from nearfar._scene.options import LoadOptions
from nearfar._scene.report import count

_POINTS_AT_ONCE = 1 << 19
"""Number of points converted at once, which take tens of megabytes."""

_KEY = "footprints"

_BLOCK = 256
"""Number of boxes in a block of the index."""


class Footprints:
    """Outlines and heights of a file's features; `content` makes triangles of them.

    `label` is the name of the file. `options` state the origin, the height property and `on_invalid`.
    """

    def __init__(self, label: str, table: Table, options: LoadOptions) -> None:
        self.label = label
        self._outlines, invalid_count = table.outlines.validate(drop=options.drops, degrees=table.degrees)
        self.count = len(self._outlines.features) - 1
        """Number of features, including those without polygons."""
        self.ground = _georeference(table, self._outlines.points, checked_origin(options.origin))
        self._low, self._high, unknown_count = _extents(table, options.height, self.count)
        names = table.columns.texts(None)
        self.names: Sequence[str] | int = self.count if names is None else distinct(names)
        """Names of the features, or their number if they have none: feature n is then called ``object_n``."""
        self.boxes = self._boxes()
        """World boxes (F, 2, 3) of the features; inverted and infinite for features without polygons."""
        # One base for all features, so that a triangle's float32 corners do not depend on the selection.
        self._base = origin_for(self.bounds)
        """Point that vertices are relative to."""
        self._index = BoxIndex(self.boxes)
        self.format = table.format
        self._system = [self.ground.note] if self.ground.keeps_coordinates else []
        own_frame = [] if self._system else [self.ground.note]
        self.notes = [*own_frame, *table.notes, *_notes(table.skipped, invalid_count, unknown_count)]

    @property
    def bounds(self) -> NDArray[np.float64]:
        """World box (2, 3) of all features; inverted and infinite if there are none."""
        least, greatest = self.boxes[:, 0], self.boxes[:, 1]
        return np.stack([least.min(axis=0, initial=np.inf), greatest.max(axis=0, initial=-np.inf)])

    def rows_touching(self, box: NDArray[np.float64]) -> NDArray[np.int64]:
        """Numbers of the features whose boxes touch a world box (2, 3), borders included, ascending."""
        return self._index.touching(box)

    def content(self, rows: NDArray[np.int64] | None = None) -> Content:
        """Triangulate some features, or all; the selection may be empty. Features keep their names."""
        outlines = self._outlines if rows is None else self._outlines.select(rows)
        numbers = np.arange(self.count) if rows is None else rows
        owner = np.arange(len(numbers)).repeat(np.diff(outlines.point_starts))
        polygon_owner = np.arange(len(numbers)).repeat(np.diff(outlines.features))
        low, high = self._low[numbers], self._high[numbers]
        vertices = np.empty((2, len(owner), 3), np.float32)
        plan = np.empty((len(owner), 2))
        for start in range(0, len(owner), _POINTS_AT_ONCE):
            part = slice(start, start + _POINTS_AT_ONCE)
            for level, ends in enumerate((low, high)):
                world = self.ground.world(outlines.points[part], ends[owner[part]])
                vertices[level, part] = world - self._base
                if level == 0:
                    plan[part] = world[:, ::2] * (1, -1)
        floors = (low > 0)[polygon_owner]
        faces, offsets, crossing_count = _core.polygon_prisms(plan, outlines.rings, outlines.polygons, floors)
        notes = [*self.notes, f"{count(crossing_count, 'polygon')} {CROSSING}"] if crossing_count else list(self.notes)
        face_object = polygon_owner.astype(np.int32).repeat(np.diff(offsets))
        shape = Shape(vertices.reshape(-1, 3), faces, face_object=face_object)
        nodes = Nodes([""], translation(self._base)[None], [_KEY])
        used = [f"{self.format}: {count(len(numbers), 'feature')} extruded", *self._system]
        return Content(self.label, {_KEY: shape}, nodes, notes, used, names=self._names_of(rows))

    def _names_of(self, rows: NDArray[np.int64] | None) -> Sequence[str] | int:
        if rows is None:
            return self.names
        if isinstance(self.names, int):
            return [f"object_{row}" for row in rows.tolist()]
        return [self.names[row] for row in rows.tolist()]

    def _boxes(self) -> NDArray[np.float64]:
        boxes = np.empty((self.count, 2, 3))
        boxes[:, 0], boxes[:, 1] = np.inf, -np.inf
        starts = self._outlines.point_starts
        filled = np.flatnonzero(np.diff(starts))
        # Chunks contain whole features, so that each box is complete after one step.
        splits = np.flatnonzero(np.diff(starts[filled] // _POINTS_AT_ONCE)) + 1
        for rows in np.split(filled, splits) if len(filled) else ():
            first, end = starts[rows[0]], starts[rows[-1] + 1]
            sizes = np.diff(starts)[rows]
            for ends in (self._low, self._high):
                world = self.ground.world(self._outlines.points[first:end], ends[rows].repeat(sizes))
                boxes[rows, 0] = np.minimum(boxes[rows, 0], np.minimum.reduceat(world, starts[rows] - first))
                boxes[rows, 1] = np.maximum(boxes[rows, 1], np.maximum.reduceat(world, starts[rows] - first))
        return boxes


def _georeference(table: Table, points: NDArray[np.float64], origin: tuple[float, float, float] | None) -> Georeference:
    if not table.degrees:
        return Projected(table.system, table.metres)
    return Geodetic.frame_centred_on(points) if origin is None else Geodetic(*origin)


def _extents(table: Table, height: str | None, number: int) -> tuple[NDArray[np.float64], NDArray[np.float64], int]:
    """Lower and upper ends of the features in metres above the ground, and the number of unknown heights."""
    high = heights.read_heights(table.columns, heights.HEIGHTS, number, height)
    low = np.nan_to_num(heights.read_heights(table.columns, heights.BASES, number, None))
    is_unknown = ~(high > low)
    return low, np.where(is_unknown, low + heights.DEFAULT_HEIGHT, high), int(is_unknown.sum())


def _notes(skipped_count: int, invalid_count: int, unknown_count: int) -> list[str]:
    notes = {
        f"{count(skipped_count, 'geometry', 'geometries')} of points or lines ignored": skipped_count,
        f"{count(invalid_count, 'polygon')} left out": invalid_count,
        f"{count(unknown_count, 'feature')} of unknown height drawn {heights.DEFAULT_HEIGHT:g} m high": unknown_count,
    }
    return [note for note, number in notes.items() if number]


class BoxIndex:
    """Spatial index of world boxes (N, 2, 3), least and greatest corners; inverted boxes touch nothing."""

    def __init__(self, boxes: NDArray[np.float64]) -> None:
        rows = np.flatnonzero((boxes[:, 0] <= boxes[:, 1]).all(axis=1))
        x, z = boxes[rows][:, :, ::2].mean(axis=1).T
        # Sort-tile-recursive packing (Leutenegger, Lopez, Edgington 1997): strips along z, each sorted by z.
        strip_blocks = max(1, round(np.sqrt(len(rows) / _BLOCK)))
        strip = np.searchsorted(np.sort(x[::_BLOCK])[::strip_blocks], x, side="right")
        low, high = z.min(initial=np.inf), z.max(initial=-np.inf)
        # One sort of both keys is several times as fast as `np.lexsort`.
        self._rows = rows[np.argsort(strip + (z - low) / max(2.0 * (high - low), 1e-300))]
        self._boxes = boxes[self._rows]
        blocks = [self._boxes[start : start + _BLOCK] for start in range(0, len(rows), _BLOCK)]
        self._blocks = np.array([(block[:, 0].min(0), block[:, 1].max(0)) for block in blocks]).reshape(-1, 2, 3)

    def touching(self, box: NDArray[np.float64]) -> NDArray[np.int64]:
        """Numbers of the boxes that touch a box (2, 3), borders included, ascending."""
        blocks = np.flatnonzero(touching(self._blocks, box))
        indices = (blocks[:, None] * _BLOCK + np.arange(_BLOCK)).ravel()
        indices = indices[indices < len(self._rows)]
        return np.sort(self._rows[indices[touching(self._boxes[indices], box)]])
