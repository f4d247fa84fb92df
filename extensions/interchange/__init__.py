"""Export formats for motion capture, animation, robot models and video."""
