"""Evaluation protocol of Lemak et al. 2020."""
