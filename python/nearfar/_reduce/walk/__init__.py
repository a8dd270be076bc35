"""Near–far scenes along a walk: a reduction for each region, made in advance, and transitions between regions."""
