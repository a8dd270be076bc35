"""Notebook display of reduced scenes: a card, the explorer, and the page's viewer."""

from __future__ import annotations

from nearfar._base import card, check
from nearfar._camera.camera import Camera
from nearfar._reduce.data import ReducedData
from nearfar._reduce.explore import Explorer
from nearfar._render.showing import View, show as make_view


class InNotebooks(ReducedData):
    """Display of a reduced scene; the base of `ReducedScene`."""

    @card.repr_html
    def _repr_html_(self) -> str:
        """Counts, radii and the map for notebooks."""
        stats = self.stats
        moving = stats["nsf"] - stats["near"] - stats["intermediate"]
        facts = [
            ("drawn", f"{stats['drawn']:,} of {stats['triangles']:,} triangles, {stats['reduction']:,.4g} times fewer"),
            ("near", f"{stats['near']:,}"),
            ("intermediate", f"{stats['intermediate']:,}"),
            *([("moving", f"{moving:,}")] if moving else []),
            ("r₁, r₂", f"{self.r1:g} m, {self.r2:g} m"),
            *([("chosen", self.reason)] if self.reason else []),
            ("morph", self.morph),
            ("centre", card.point(self.center)),
            ("copies of near geometry", f"{stats['near_bytes'] / 1e6:,.1f} MB"),
        ]
        if self.env is None:
            return card.page("ReducedScene", facts, notes=["Nothing lies beyond the near part, so there is no map."])
        facts.append(("map", f"6 × {self.env.face_size}² texels, {stats['map_bytes'] / 1e6:,.1f} MB"))
        _, pixels = self.env._preview()
        caption = "the map: what the centre sees beyond the near part, −z in the middle"
        return card.page("ReducedScene", facts, card.picture(pixels, "environment map", caption))

    def explore(self, *, size: tuple[int, int] = (400, 250), face_size: int = 256) -> Explorer:
        """Show the picture beside the truth in a notebook, with sliders for the user and the radii.

        Parameters
        ----------
        size
            Width and height of both pictures in pixels, 16 to 2048.
        face_size
            Number of texels across the faces of maps baked by the explorer, 1 to 1024: at the start, because
            discontinuity needs range, and whenever a radius slider is released.

        Returns
        -------
        Explorer
            A notebook shows it if it is the last value of a cell. Its sliders are attributes, and `reduced` is the
            reduced scene of the present radii. The user stays within the near zone, ρ ≤ r1.

        Raises
        ------
        ImportError
            If ipywidgets is not installed.
        ValueError, TypeError
            Arguments out of range.
        """
        for name, value in zip(("size[0]", "size[1]"), check.size("size", size), strict=True):
            check.integer(name, value, 16, 2048)
        return Explorer(self, size=size, face_size=check.integer("face_size", face_size, 1, 1024))

    def show(
        self, *, size: tuple[int, int] = (640, 400), camera: Camera | None = None, strategy: str = "clovr"
    ) -> View:
        """Show the reduced scene in a notebook: the page's viewer, in which the user walks and looks around.

        Files are sent to the browser as notebook messages, so that Python may run on another machine.

        Parameters
        ----------
        size
            Width and height in pixels of the browser, 16 to 8192; smaller if a cell is narrower.
        camera
            Initial view of the user; by default at the centre, looking along −z, with a vertical field of view of 75°.
        strategy
            "clovr": the near part fades in, and the morph grows by its strength. "clovrd": it is shown at once.

        Returns
        -------
        View
            A widget, which a notebook shows if it is the last value of a cell. Its `camera` can be read and set, as
            can `position`, `yaw`, `pitch` (radians) and `angle` (degrees); `ring`, `region`, `radius`, `strength` and
            `problem` can be read. Places without widgets, such as saved notebooks, show a picture.

        Raises
        ------
        ImportError
            If anywidget is not installed.
        ValueError, TypeError
            Arguments out of range, such as a camera with roll, or a scene without a morph.
        """
        return make_view(self, center=self.center, size=size, camera=camera, strategy=strategy)
