"""Runs the command line with `python -m nearfar.cli`."""

from nearfar.cli import main

main()
