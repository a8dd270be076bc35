"""Web page that shows bundles in a browser, and its files."""

from __future__ import annotations

from nearfar.view._page import write_page

__all__ = ["write_page"]
