"""IMUs and markers on a hand: their file and their geometry."""
