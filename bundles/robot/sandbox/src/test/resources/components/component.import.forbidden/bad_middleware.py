import rclpy
from sensor_msgs.msg import LaserScan


class TTC:
    def execute(self, distance, speed):
        return {"ttc": 1.0}
