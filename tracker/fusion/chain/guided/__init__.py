"""What the chain filter learns from poses that a wearer holds on request."""
