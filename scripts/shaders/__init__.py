"""Shader snippets for engines, translated from tested WGSL: `python -m scripts.shaders.write`."""
