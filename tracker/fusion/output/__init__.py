"""The output of all filters: the whole hand with validity states and standard deviations."""
