"""A drill of device faults."""
