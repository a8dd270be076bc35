"""Measurement of levels: SSIM over size, and curves fitted to it."""
