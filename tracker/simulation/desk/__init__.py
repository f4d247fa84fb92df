"""Images of a gloved hand over a desk as a camera in a room gives them."""
