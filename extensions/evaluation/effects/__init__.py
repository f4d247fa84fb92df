"""Evaluation with what real devices do and ideal ones do not, each alone and all at once."""
