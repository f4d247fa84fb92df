"""Images of a gloved hand over a desk, as from a camera in a room."""
