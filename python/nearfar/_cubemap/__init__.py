"""Cube maps: look-ups, layouts of pictures of all directions, and environment maps."""
