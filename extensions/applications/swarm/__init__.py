"""A drone swarm that is nudged, stretched and split by hand (Lee et al. 2021, Fig. 1D, movie 2)."""
