"""Hands that leave the view for a while and return."""
