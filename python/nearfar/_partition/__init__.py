"""The near–far partition of a scene by radius, and the load curve: the number of triangles within each radius."""
