"""How the chain filter finds a hand from nothing."""
