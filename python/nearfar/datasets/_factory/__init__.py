"""A factory hall: steelwork, machines, robots, pipes, tanks, racks, a gangway.

CloVR (2024) streams such a hall ring after ring; the objects and their sizes here are nearfar's.
"""
