"""Eventchain's runtime for nodes based on `rclpy`: an in-memory ROS graph in simulated time."""
