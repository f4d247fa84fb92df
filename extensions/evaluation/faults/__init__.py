"""Fault injection into simulated devices."""
