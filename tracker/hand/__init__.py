"""The skeleton: its file, its kinematics, and conversion to other conventions."""
