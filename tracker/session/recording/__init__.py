"""Recording in a process of its own, so that neither encoding nor the disk is in anyone's way."""
