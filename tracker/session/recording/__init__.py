"""Recording in a child process, so that encoding and the disk do not delay other threads."""
