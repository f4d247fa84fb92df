"""What the tracker has learned of the wearer and of the sensors."""
