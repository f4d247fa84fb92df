"""What a glove's builder prints: the markers in true size, the wiring, the camera's board."""
