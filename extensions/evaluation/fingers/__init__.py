"""``evaluate fingers``: each fingertip with and without the glove's cloth."""
