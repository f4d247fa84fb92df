"""Evaluation protocols of the papers: motions, errors, metrics, tables and figures."""
