"""Variants of the filters that serve as baselines in comparisons."""
