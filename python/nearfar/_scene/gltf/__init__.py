"""Reads glTF and GLB files."""
