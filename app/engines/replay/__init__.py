"""A recorded session that behaves like a live engine, so that the same panels show it."""
