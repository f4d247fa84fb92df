"""Fixtures for the tests of the program (`tests`) and of each extension (`extensions/*/tests`)."""

pytest_plugins = ["tests.fixtures"]
