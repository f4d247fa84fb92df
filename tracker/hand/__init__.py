"""The skeleton: its file, its kinematics, and the conventions of others."""
