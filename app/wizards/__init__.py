"""Dialogs that guide through a set-up step by step."""
