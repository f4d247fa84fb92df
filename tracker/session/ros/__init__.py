"""ROS 2 messages and topics."""
