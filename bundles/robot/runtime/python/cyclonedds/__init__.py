"""The API of Eclipse Cyclone DDS for Python, as far as generated nodes use it; everything comes from `eventchain_ros2`.

This package stands on `sys.path` only within the lock-step host. Everywhere else `cyclonedds` is the real one.
"""
