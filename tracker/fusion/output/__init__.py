"""What every filter shows: the whole hand with states and standard deviations."""
