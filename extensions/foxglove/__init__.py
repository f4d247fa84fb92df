"""A Foxglove live server: estimates as JSON for plots and as a scene for the 3D panel."""
