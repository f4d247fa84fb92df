"""The guided touch test in the window."""
