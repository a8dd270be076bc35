"""Levels measured: SSIM over size, and the curves through it."""
