"""Scenes: meshes, instances and materials, from files, trimesh objects, arrays or a builder."""
