"""The guided measurement of the axes of a glove's IMUs."""
