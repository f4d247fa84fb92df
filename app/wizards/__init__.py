"""Dialogs that lead through a set-up step by step."""
