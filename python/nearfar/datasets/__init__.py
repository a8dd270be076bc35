"""Procedural scenes: deterministic, from thousands to tens of millions of triangles."""
