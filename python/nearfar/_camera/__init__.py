"""Cameras and their projections; distances in depth buffers."""
