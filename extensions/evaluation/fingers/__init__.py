"""``evaluate fingers``: each fingertip with and without the glove's cloth, and with true
silhouettes."""
