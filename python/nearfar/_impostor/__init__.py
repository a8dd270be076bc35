"""Impostors: the far part of a scene as textured quads baked from several centres, and their file."""
