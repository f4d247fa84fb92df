"""What a hand does: applications, drawn around it."""
