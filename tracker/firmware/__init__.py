"""The glove's firmware as the program brings it, and how it gets into a glove."""
