"""The 3D view: a scene, and two ways to draw it."""
