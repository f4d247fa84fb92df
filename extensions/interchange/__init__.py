"""Export formats of motion capture, animation, robot models and films."""
