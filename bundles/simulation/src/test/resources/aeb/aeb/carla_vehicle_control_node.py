"""A node in the shape of the generated ones: it connects a component with its topics."""

import rclpy
from rclpy.node import Node
from carla_msgs.msg import CarlaEgoVehicleControl
from std_msgs.msg import Float32

from aeb.components.Carla_Vehicle_Control import Carla_Vehicle_Control


class Carla_Vehicle_Control_node(Node):
    """Executes Carla_Vehicle_Control at 20 Hz."""

    def __init__(self):
        super().__init__("Carla_Vehicle_Control_node")
        self.component = Carla_Vehicle_Control()
        self.braking_force = None
        self.create_subscription(Float32, "/vehicle/brake_force", self.on_input_0, 10)
        self.output_0 = self.create_publisher(CarlaEgoVehicleControl, "/carla/ego_vehicle/vehicle_control_cmd", 10)
        self.timer = self.create_timer(1.0 / 20.0, self.execute)

    def on_input_0(self, message):
        """Keep the newest message of /vehicle/brake_force."""
        self.braking_force = message.data

    def execute(self):
        """Run the component on the newest inputs and publish what it returns."""
        if self.braking_force is None:
            return
        output = self.component.execute(
            braking_force=self.braking_force,
        )
        message = CarlaEgoVehicleControl()
        message.throttle = output["throttle"]
        message.steer = output["steer"]
        message.brake = output["brake"]
        message.hand_brake = output["hand_brake"]
        message.reverse = output["reverse"]
        self.output_0.publish(message)


def main(args=None):
    """Run the node until it is shut down."""
    rclpy.init(args=args)
    rclpy.spin(Carla_Vehicle_Control_node())
    rclpy.shutdown()
