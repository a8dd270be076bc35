"""Image quality: structural similarity, pixel errors, discontinuity, and a comparison by all of them."""
