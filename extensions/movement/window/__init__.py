"""A report as a job of the window."""
