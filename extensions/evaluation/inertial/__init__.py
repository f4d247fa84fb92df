"""The protocol of Lemak et al. 2020."""
