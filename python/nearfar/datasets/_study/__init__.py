"""The three tasks of a user study: count spheres, follow a tape, follow a ball.

Popescu, Lee, Choi, Fahmy (2022) gave the tasks to users who saw near and far part combined by different methods. The
events of the scenes follow the paper; sizes and distances are nearfar's, for the paper's radii of 30 m and 50 m.
"""
