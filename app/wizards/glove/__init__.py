"""The glove set-up."""
