"""A class of this name that is no node of ROS 2, in a file that uses a message."""

from std_msgs.msg import Float32


class Node:
    pass


class TTC(Node):
    def execute(self, distance, speed):
        return {"ttc": Float32(data=distance).data}
