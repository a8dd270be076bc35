"""Scenes put together piece by piece; the procedural datasets go through it."""

from __future__ import annotations

from collections.abc import Iterable

from nearfar._scene.assembly import Assembly
from nearfar._scene.scene import Scene


class SceneBuilder(Assembly):
    """Puts a scene together from materials, meshes and their placements.

    `material`, `mesh` and `objects` register parts and return their numbers; `instance` and `place_many` place meshes;
    `build` makes the scene. Meshes placed once are merged, those placed again stay instances.
    """

    def build(self, dynamic: Iterable[str] = ()) -> Scene:
        """Make the scene.

        Parameters
        ----------
        dynamic
            Names of objects that `Scene.at` can pose; they keep meshes of their own.
        """
        return Scene._from_assembled(self.assemble(dynamic))
