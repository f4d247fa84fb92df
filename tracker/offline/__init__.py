"""Work without devices: making simulated sessions, tracking recorded ones again."""
