"""Set-up of the glove."""
