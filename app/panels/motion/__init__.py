"""The Motion panel: angles and distances as numbers, bars and curves."""
