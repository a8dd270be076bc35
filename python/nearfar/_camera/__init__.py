"""Cameras and their projections, and conversion between depth buffers and distances."""
