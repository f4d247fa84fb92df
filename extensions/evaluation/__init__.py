"""The papers' protocols: motions, errors, metrics, tables and figures."""
