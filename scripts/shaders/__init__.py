"""Snippets of shaders for engines, translated from WGSL that vectors test: `python -m scripts.shaders.write`."""
