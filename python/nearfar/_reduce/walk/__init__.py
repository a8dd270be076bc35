"""Near–far scenes along a whole walk: a reduction for each region, made ahead, and the pictures of changes between."""
