"""The stages connected: one hand or two, synchronous, without threads or a clock."""
