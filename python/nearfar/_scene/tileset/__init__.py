"""Reads 3D Tiles 1.0 and 1.1: tilesets at a stated detail, and single tiles."""
