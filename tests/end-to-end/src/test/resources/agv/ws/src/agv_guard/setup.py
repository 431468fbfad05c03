from setuptools import setup

scripts = ["speed_guard = agv_guard.speed_guard:main"]
setup(name="agv_guard", packages=["agv_guard"], entry_points={"console_scripts": scripts})
