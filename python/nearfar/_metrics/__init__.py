"""Image quality: similarity, pixel errors, discontinuity, and the comparison of methods."""
