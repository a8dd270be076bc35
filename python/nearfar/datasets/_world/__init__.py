"""An Earth-like landscape of any size, generated cell by cell: relief, water, climate, forests, towns and roads."""
