"""The guided check in the window."""
