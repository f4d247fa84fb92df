"""Rotations, quaternions and projections: small functions, tested against SciPy."""
