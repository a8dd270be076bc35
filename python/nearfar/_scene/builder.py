"""Public builder of scenes from materials, meshes and placements; the procedural datasets use it, too."""

from __future__ import annotations

from collections.abc import Iterable

from nearfar._scene.assembly import Assembly
from nearfar._scene.scene import Scene


class SceneBuilder(Assembly):
    """Builds a scene from materials, meshes and their placements.

    `material` and `mesh` add parts and return their numbers; `objects` declares object names; `instance` and
    `place_many` place meshes; `build` makes the scene. Static meshes placed once are merged; the others stay instances.
    """

    def build(self, dynamic: Iterable[str] = ()) -> Scene:
        """Make the scene; `Scene.at` can pose the objects named in `dynamic`, whose meshes are not merged."""
        return Scene(**self._assemble(dynamic))
