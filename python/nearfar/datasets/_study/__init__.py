"""The three tasks of a user study: count spheres, follow a tape, follow a ball.

Popescu, Lee, Choi, Fahmy (2022) compared methods that combine a near and a far part by these tasks. The scenes follow
the paper, with its radii of 30 m and 50 m; sizes and other distances are nearfar's.
"""
