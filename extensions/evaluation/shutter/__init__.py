"""Evaluation of cameras that expose one row after the other, with fast hands and a turning head."""
