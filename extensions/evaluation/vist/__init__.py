"""Evaluation protocol of Lee et al. 2021."""
