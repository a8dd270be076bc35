"""Lenses of headsets: distortion and its inverse, warped pictures and meshes, and solid angles seen through a lens."""
