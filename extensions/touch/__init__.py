"""The touch test: how accurate the tracked fingertips are, measured with a printed sheet."""
