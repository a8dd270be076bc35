"""Rendering: frames and their channels, the choice between CPU and GPU, ground truth, sequences, baking."""
