"""Creation of levels by simplification."""
