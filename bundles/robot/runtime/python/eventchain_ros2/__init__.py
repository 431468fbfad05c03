"""Eventchain's runtime for nodes written against `rclpy`: an in-memory ROS graph in simulated time."""
