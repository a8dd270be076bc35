"""Reduction of 3D scenes that are too heavy for a thin VR device, and measures of the loss in image quality."""

import lazy_loader

# Each public name is imported on first use, so that a script pays only for the stages that it uses.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
