"""Settings of the connected devices."""
