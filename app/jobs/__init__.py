"""Long work beside the window: exports, tracking again, outputs."""
