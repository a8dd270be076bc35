"""Selection of levels by size, lens and gaze, and the sizes at which engines switch."""
