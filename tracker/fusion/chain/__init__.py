"""The default filter: one articulated chain of segments (docs/chain.md)."""
