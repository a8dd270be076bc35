"""Reduction of 3D scenes that are too heavy for a thin VR device, and measures of the loss in image quality."""

import lazy_loader

from nearfar._render import showing as _showing

# Each public name is imported on first use, so that a script pays only for the stages that it uses.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


def _make_view(*shown, **settings):
    from nearfar.view._widget import Widget

    return Widget(*shown, **settings)


# Early stages show results in the widget of the stage view. They may not import it, so it is set here.
_showing.set_maker(_make_view)
