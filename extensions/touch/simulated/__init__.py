"""Simulated wearers who take the touch test, to compare its figures with the true error."""
