"""The window used as a tool: screenshots, soak test, headless report."""
