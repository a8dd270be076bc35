"""Lenses of headsets: distortion and its inverse, warped pictures and meshes, sizes seen through a lens."""
