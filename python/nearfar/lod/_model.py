"""The model of an object's levels: each level's score over size, with files and plots."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, SupportsFloat

import numpy as np
from numpy.typing import NDArray

from nearfar._base import card, check, formats, plot
from nearfar._camera.camera import Camera, Fov
from nearfar.hmd._hmd import Hmd
from nearfar.lod import _export, _file
from nearfar.lod._measure import statistic
from nearfar.lod._measure.statistic import Mean
from nearfar.lod._measured_levels import MeasuredLevels
from nearfar.lod._select.rules import Mode
from nearfar.lod._select.select import Selector
from nearfar.lod._select.switches import read_floor
from nearfar.lod._select.threshold import Kind, LodThreshold, threshold_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class LodModel(MeasuredLevels):
    """Levels of an object with their curves, the input of `select`.

    `measure` makes models. A model of known curves is, for example, `LodModel(triangles=[9000, 800],
    curves=Curve4PL([1], [1], [1e-3], [0.5]))`. Level 0 is the base, whose score is 1; level i > 0 has the curve
    `curves[i - 1]`.

    Parameters
    ----------
    triangles
        Triangle count of each level (K,), level 0 first.
    curves
        K − 1 curves: SSIM over solid angle in steradians.
    center, radius
        The base's bounding sphere, metres in the object's frame.
    sigma
        Least and greatest measured solid angle, steradians; by default 0 and 4π. Above the greatest only level 0 is
        used; below the least, curves are constant.
    errors
        Greatest distance of each level (K,) from the base, metres; by default 0.
    pixel
        Tangent of the angle of a pixel in the middle of the measured pictures. `select` converts sizes to these pixels
        before it evaluates curves. None, the default, ignores pixel sizes.
    name
        Name of the object.
    levels
        The geometry, if available; as many levels as in `triangles`.
    measured
        Settings and work of the measurement, in JSON values.
    samples
        Scores to which the curves were fitted; None if nothing was measured.
    """

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the model without geometry as JSON, atomically: curves, samples, and how they were measured.

        `export` also writes the geometry, as `.glb`: ValueError for that suffix. OSError if the file cannot be written.
        """
        target = check.path("path", path)
        if target.suffix.lower() == ".glb":
            raise ValueError(f"path: expected the name of a JSON file, got {target}; `export` writes GLB")
        formats.write_json(target, _file.encode_document(self))

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> LodModel:
        """Read a file of `save` or `export`, bit for bit; `.glb` includes the geometry.

        FormatError for other files and newer versions, OSError if there is none.
        """
        source = check.path("path", path)
        with source.open("rb") as file:
            is_glb = source.suffix.lower() == ".glb" or file.read(4) == b"glTF"
        read = _export.read if is_glb else _file.read
        with formats.guarded(source):
            return cls(**read(source))

    def export(
        self,
        path: str | os.PathLike[str],
        *,
        view: Hmd | Camera | Fov,
        k: float | None = None,
        d: float | None = None,
        threshold: LodThreshold | Kind | None = None,
        quality: float | None = None,
        floor: Iterable[SupportsFloat] = (),
        all_levels: bool = False,
    ) -> None:
        """Write the model for engines, atomically; engines switch levels at sizes given by the curves.

        ValueError and TypeError for arguments out of range, other suffixes, or GLB for a model without geometry;
        OSError if the file cannot be written. Source: Khronos Group, glTF 2.0, extension MSFT_lod.

        Parameters
        ----------
        path
            `.glb`: the geometry with `MSFT_lod`. `MSFT_screencoverage` has the sizes at which levels switch, as shares
            of the picture's area covered by the bounding sphere. Programs without the extension show level 0. `.json`:
            the document of `save` with an entry `switches`, which has these sizes in several units (see `switches`). A
            GLB has the same document in its first node's `extras.nearfar`. `load` reads both back, bit for bit; the
            scenes of its levels have one object with the triangles, surfaces and normals.
        view, k, d, threshold, quality, floor
            The screen and the threshold, as in `switches`.
        all_levels
            Also write levels that are never shown because a coarser one is good enough up to the same or a greater
            size. Another screen or threshold may show them. By default they are left out.
        """
        target, limit = check.path("path", path, ".glb", ".json"), threshold_of(threshold, k, d, quality)
        heights, all_levels = read_floor(floor), check.flag("all_levels", all_levels)
        _export.write(self, target, view=view, threshold=limit, floor=heights, all_levels=all_levels)

    def refit(self, percentile: float | Mean) -> LodModel:
        """Return the model with curves through another percentile of the same views, or their mean, without rendering.

        `percentile` is 0 to 100, or "mean", as in `MeasureSettings`. The levels, and the sizes at which each was
        measured, do not change; "chosen_by" in the result's `measured` is the percentile that chose them. For a model
        with all levels at all sizes (`step=None, saturated=None`), the curves are those of `measure` with the new
        percentile. ValueError and TypeError for an invalid percentile, or a model without the scores of single views
        (`samples.views`).
        """
        percentile = statistic.check_percentile(percentile)
        if self.samples is None or self.samples.views is None:
            raise ValueError(f"model: expected the scores of single views in samples.views, got none in {self.name!r}")
        samples = replace(self.samples, score=statistic.of_views(self.samples.views, percentile))
        chosen_by = self.measured.get("chosen_by", self.measured.get("percentile"))
        measured = self.measured | {"percentile": percentile, "chosen_by": chosen_by}
        return replace(self, curves=statistic.curves_through(samples), samples=samples, measured=measured)

    def selector(self, mode: Mode) -> Selector:
        """Return the `Selector` that `nearfar.render` uses for a mode: all other settings have their defaults."""
        return Selector(mode=mode)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Plot each level's scores over solid angle, with its curve, on Matplotlib's axes, by default new ones.

        ImportError if Matplotlib is not installed. Source: Liebisch (2021), Figure 3.3.
        """
        sigma, curves, labels = self._curve_lines(256)
        scores = None if self.samples is None else (self.samples.sigma, self.samples.score[1:])
        return plot.score_curves(ax, sigma, curves, labels, scores)

    @card.repr_html
    def _repr_html_(self) -> str:
        """Table of the levels and plot of their curves, for notebooks."""
        sigma, curves, labels = self._curve_lines(128)
        samples = self.samples
        dots = [None] * len(curves) if samples is None else [(samples.sigma, score) for score in samples.score[1:]]
        lines = [card.Line(sigma, y, label, dot) for y, label, dot in zip(curves, labels, dots, strict=True)]
        header, rows = self._rows()
        plots = [card.plot(lines, "solid angle, sr", "SSIM")] if lines else []
        title = f"LodModel {self.name}, radius {self.radius:.4g} m"
        return card.page(title, (), *plots, card.table(rows, header))

    def _curve_lines(self, count: int) -> tuple[NDArray[np.float64], NDArray[np.float64], list[str]]:
        """Sizes in the measured range, or in six decades if the least size is 0; values of the curves; their labels."""
        low, high = self.sigma
        sigma = np.geomspace(low if low > 0 else 1e-6 * high, high, count)
        return sigma, self.curves(sigma), [f"{count:,}" for count in self.triangles[1:]]

    def _rows(self) -> tuple[list[str], list[list[str]]]:
        """Header and rows of the table of levels, as text."""
        low, high = self.sigma
        scores = [(1.0, 1.0), *map(tuple, self.curves([high, low]).tolist())]
        status = ["", *self.curves.status.tolist()]
        header = ["level", "triangles", "error m", f"{high:.3g} sr", f"{low:.3g} sr", "curve"]
        columns = zip(self.triangles.tolist(), self.errors.tolist(), scores, status, strict=True)
        return header, [
            [str(number), f"{triangles:,}", f"{error:.3g}", f"{large:.4f}", f"{small:.4f}", how]
            for number, (triangles, error, (large, small), how) in enumerate(columns)
        ]

    def __repr__(self) -> str:
        counts = ", ".join(f"{count:,}" for count in self.triangles)
        return f"LodModel({self.name!r}: {counts} triangles)"

    def __str__(self) -> str:
        """Table of the levels: triangles, error, scores at the greatest and the least size, outcome of the fit."""
        header, rows = self._rows()
        widths = (5, 11, 9, 10, 10)
        lines = [
            "  ".join([*(f"{cell:>{width}}" for cell, width in zip(row, widths, strict=False)), row[-1]]).rstrip()
            for row in (header, *rows)
        ]
        return "\n".join([f"{self.name}, radius {self.radius:.4g} m", *lines])
