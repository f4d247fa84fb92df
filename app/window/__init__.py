"""The main window: commands, layout, status bar, theme."""
