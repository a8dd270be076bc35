"""Hostile files, arguments, signals, kills and full disks against the package; `python -m tests.attack` runs them."""
