"""The near–far partition of a scene by radius, and the load curve: triangles within each radius."""
