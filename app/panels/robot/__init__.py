"""The robot hand beside the wearer's."""
