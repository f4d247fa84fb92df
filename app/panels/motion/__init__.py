"""The motion as numbers, bars and curves."""
