"""Finding a hand without a prior pose."""
