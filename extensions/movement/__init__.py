"""Outputs for movement science: BIDS data sets, OpenSim models and motions, reports."""
