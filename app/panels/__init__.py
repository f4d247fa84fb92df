"""The docks of the window; each reads view-models and forwards what the user does."""
