"""Ray casting into a scene, nearest points on its surface, and the choice of viewpoints by ray casting."""
