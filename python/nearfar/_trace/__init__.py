"""Rays cast into a scene, nearest points on it, and viewpoints found by casting rays."""
