"""Two hands before one camera: together against each alone."""
