"""ros2 launch glovetrack_ros glovetrack.launch.py [params:=FILE]"""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description() -> LaunchDescription:
    """The node with the parameters of a file."""
    usual = Path(get_package_share_directory("glovetrack_ros")) / "config" / "glovetrack.yaml"
    node = Node(
        package="glovetrack_ros",
        executable="glovetrack_node",
        name="glovetrack",
        parameters=[LaunchConfiguration("params")],
        output="screen",
    )
    return LaunchDescription([DeclareLaunchArgument("params", default_value=str(usual)), node])
