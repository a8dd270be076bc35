"""Tests by stage, and in `project` those of the project as a whole; run from the checkout."""
