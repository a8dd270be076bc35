"""An Earth-like landscape of any size, made cell by cell: relief, water, climate, forests, towns and roads."""
