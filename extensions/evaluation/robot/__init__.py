"""Evaluation of teleoperation: fingertip errors, and picking and placing a cube."""
