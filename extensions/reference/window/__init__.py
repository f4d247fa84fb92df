"""Import of references and the accuracy report in the window."""
