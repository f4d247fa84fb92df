"""The 3D view: a scene, and two renderers."""
