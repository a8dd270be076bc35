"""Tests by stage, and in `project` tests of the project as a whole; run from the checkout."""
