"""How well a robot hand follows, and whether it can take a cube and put it down."""
