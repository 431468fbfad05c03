"""The part of the Python API of Eclipse Cyclone DDS that generated nodes use; implemented in `eventchain_ros2`.

This package is on `sys.path` only within the lock-step host. Everywhere else `cyclonedds` is the real package.
"""
