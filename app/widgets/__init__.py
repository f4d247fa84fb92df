"""Small pieces of screen that know nothing of hands."""
