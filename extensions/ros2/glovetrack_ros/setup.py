"""The package for colcon (ament_python)."""

from setuptools import setup

NAME = "glovetrack_ros"

setup(
    name=NAME,
    version="0.2.0",
    packages=[NAME],
    data_files=[
        ("share/ament_index/resource_index/packages", [f"resource/{NAME}"]),
        (f"share/{NAME}", ["package.xml"]),
        (f"share/{NAME}/launch", ["launch/glovetrack.launch.py"]),
        (f"share/{NAME}/config", ["config/glovetrack.yaml"]),
    ],
    install_requires=["setuptools"],
    license="Apache-2.0",
    entry_points={"console_scripts": [f"glovetrack_node = {NAME}.node:main"]},
)
