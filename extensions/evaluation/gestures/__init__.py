"""Evaluation of gesture recognition on simulated and recorded hands."""
