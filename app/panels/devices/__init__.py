"""All settings of the devices that are open."""
