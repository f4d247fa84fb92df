"""Evaluation of two hands before one camera, compared with each hand alone."""
