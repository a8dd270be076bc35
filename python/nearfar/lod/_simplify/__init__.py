"""Levels made by simplification."""
