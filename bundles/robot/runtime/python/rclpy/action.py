"""Actions are not part of this runtime."""

raise ImportError("rclpy.action: actions are not part of Eventchain's runtime")
