"""Budgets of triangles and bytes: bakes with other settings, and drops quads, until near and far part keep them."""

from __future__ import annotations

import logging
import math
from dataclasses import replace

from nearfar import _core
from nearfar._impostor import bake, file
from nearfar._impostor.bake import Baked, Region
from nearfar._impostor.settings import MIN_FACE_SIZE, ImpostorSettings
from nearfar._partition.partition import Partition

BUDGET_ERROR_PX = 8.0
"""Greatest error, pixels, that a budget chooses."""

_MAX_BAKES = 5
"""Greatest number of bakes for one budget."""
_FULL = 0.95
"""Share of a budget from which no finer settings are looked for."""
_MAX_CUTS = 8
"""Number of files that are encoded to find the quads that a budget of bytes allows."""


class Budget:
    """Bakes of one scene until near and far part keep the budgets of its settings."""

    def __init__(
        self,
        zones: Partition,
        region: Region,
        settings: ImpostorSettings,
        earlier: _core.ImpostorSheets | None = None,
    ) -> None:
        self._zones, self._region, self._settings, self._earlier = zones, region, settings, earlier
        self.bakes = 0
        """Number of bakes so far."""
        self.dropped = (0, 0)
        """Numbers of quads that were dropped from the last bake, and of the texels that they showed."""

    def bake(self) -> Baked:
        """Bake within the budgets; ValueError for a budget that the near part alone exceeds."""
        baked = self._bake(self._settings)
        if baked.quads is not None and self._settings.triangles is not None:
            baked = self._reduce_triangles(baked, self._settings.triangles)
        if baked.quads is not None and self._settings.bytes is not None:
            baked = self._reduce_bytes(baked, self._settings.bytes)
        return baked

    def as_geometry(self, baked: Baked) -> Baked | None:
        """Return a bake with the far triangles that users see instead of quads, if that takes no more bytes."""
        geometry = bake.as_geometry(self._zones, self._region, baked)
        if geometry is None or self._file_size(geometry) > self._file_size(baked):
            return None
        self.dropped = (0, 0)
        return geometry

    def _bake(self, settings: ImpostorSettings) -> Baked:
        self.bakes += 1
        self.dropped = (0, 0)
        baked = bake.bake(self._zones, self._region, settings, self._earlier)
        if settings.triangles is not None and len(baked.near) > settings.triangles:
            raise ValueError(
                f"triangles: expected at least the {len(baked.near):,} of the near part within "
                f"r2 = {self._region.r2:g} m, got {settings.triangles:,}; a lower r2 leaves fewer"
            )
        return baked

    def _reduce_triangles(self, finest: Baked, budget: int) -> Baked:
        """Find the least error that keeps a budget, or drop quads if the greatest error doesn't."""

        def is_within(baked: Baked) -> bool:
            return len(baked.near) + baked.far_count <= budget

        def bake_with(error_px: float) -> Baked:
            return self._bake(replace(self._settings, error_px=error_px))

        if is_within(finest):
            return finest
        coarse = finest if finest.settings.error_px >= BUDGET_ERROR_PX else bake_with(BUDGET_ERROR_PX)
        while is_within(coarse) and coarse is not finest and self.bakes < _MAX_BAKES:
            if coarse.far_count >= _FULL * (budget - len(coarse.near)):
                break
            middle = bake_with(math.sqrt(finest.settings.error_px * coarse.settings.error_px))
            if is_within(middle):
                coarse = middle
            else:
                finest = middle
        return coarse if is_within(coarse) else self._keep(coarse, budget - len(coarse.near))

    def _reduce_bytes(self, baked: Baked, budget: int) -> Baked:
        """Lower resolution and accuracy together until the file keeps a budget, or drop quads."""
        fixed = self._file_size(replace(baked, quads=None))
        if fixed > budget:
            raise ValueError(
                f"bytes: expected at least the {fixed:,} of the near part within r2 = {self._region.r2:g} m, got "
                f"{budget:,}; a lower r2 leaves less"
            )
        size, most = self._file_size(baked), self.bakes + _MAX_BAKES - 1
        while size > budget and self.bakes < most and baked.settings.face_size > MIN_FACE_SIZE:
            scale = _FULL * math.sqrt((budget - fixed) / (size - fixed))
            face_size = max(MIN_FACE_SIZE, int(scale * baked.settings.face_size))
            error_px = max(baked.settings.error_px, min(BUDGET_ERROR_PX, baked.settings.error_px / max(scale, 1e-3)))
            baked = self._bake(replace(baked.settings, face_size=face_size, error_px=error_px))
            if self._settings.triangles is not None:
                baked = self._keep(baked, self._settings.triangles - len(baked.near))
            size = self._file_size(baked)
        if size <= budget:
            return baked
        low, high = 0, baked.far_count
        for _ in range(_MAX_CUTS):
            middle = (low + high) // 2
            low, high = (middle, high) if self._file_size(self._cut(baked, middle)) <= budget else (low, middle)
        return self._keep(baked, low)

    def _keep(self, baked: Baked, triangles: int) -> Baked:
        """Drop the quads that show fewest texels beyond so many triangles, and count them."""
        kept = self._cut(baked, triangles)
        if baked.quads is not None and kept is not baked:
            quads = kept.quads
            texels = int(baked.quads.texels.sum()) - (0 if quads is None else int(quads.texels.sum()))
            count = len(baked.quads) - (0 if quads is None else len(quads))
            self.dropped = (self.dropped[0] + count, self.dropped[1] + texels)
            logging.getLogger("nearfar").info("reduce: dropped %d quads for the budget", count)
        return kept

    def _cut(self, baked: Baked, triangles: int) -> Baked:
        if baked.quads is None or baked.far_count <= triangles:
            return baked
        quads = baked.quads.keep_largest(triangles)
        return replace(baked, quads=quads if len(quads) else None)

    def _file_size(self, baked: Baked) -> int:
        near = self._zones.scene.subset(triangles=baked.near)
        region = replace(self._region, error_px=baked.settings.error_px)
        return len(file.encode(baked.quads, region, near=near).data)
