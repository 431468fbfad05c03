from setuptools import setup

package_name = "radar_tracker"

setup(
    name=package_name,
    version="0.1.0",
    packages=[package_name],
    data_files=[("share/" + package_name, ["package.xml"])],
    entry_points={"console_scripts": ["tracker = radar_tracker.tracker:main"]},
)
