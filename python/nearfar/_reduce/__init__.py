"""Near–far reduction of a scene to near geometry and an environment map, its rendering, and its files."""
