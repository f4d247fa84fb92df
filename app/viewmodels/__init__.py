"""What each panel shows, computed from messages; plain Python, no Qt."""
