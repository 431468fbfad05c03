"""A node in the shape of the generated ones: it connects a component with its topics."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32

from aeb.components.Braking_Decision import Braking_Decision


class Braking_Decision_node(Node):
    """Executes Braking_Decision at 20 Hz."""

    def __init__(self):
        super().__init__("Braking_Decision_node")
        self.component = Braking_Decision()
        self.time_to_collision = None
        self.create_subscription(Float32, "/aeb/time_to_collision", self.on_input_0, 10)
        self.output_0 = self.create_publisher(Float32, "/vehicle/brake_force", 10)
        self.timer = self.create_timer(1.0 / 20.0, self.execute)

    def on_input_0(self, message):
        """Keep the newest message of /aeb/time_to_collision."""
        self.time_to_collision = message.data

    def execute(self):
        """Run the component on the newest inputs and publish what it returns."""
        if self.time_to_collision is None:
            return
        output = self.component.execute(
            time_to_collision=self.time_to_collision,
        )
        message = Float32()
        message.data = output["braking_force"]
        self.output_0.publish(message)


def main(args=None):
    """Run the node until it is shut down."""
    rclpy.init(args=args)
    rclpy.spin(Braking_Decision_node())
    rclpy.shutdown()
