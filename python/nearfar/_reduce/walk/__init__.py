"""Near–far scenes along a walk: a reduction for each region, made ahead, and transitions between regions."""
