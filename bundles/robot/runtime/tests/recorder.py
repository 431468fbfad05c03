"""A node that records its timers and what it receives."""

from __future__ import annotations

from typing import Any

from rclpy.node import Node

MILLISECOND = 1_000_000


def number(value: float) -> Any:
    from std_msgs.msg import Float32

    return Float32(data=value)


class Recorder(Node):
    """Records the times of its timers and of received samples, in ms."""

    def __init__(self, name: str = "recorder") -> None:
        super().__init__(name)
        self.fired: list[float] = []
        self.received: list[tuple[float, float]] = []

    def milliseconds(self) -> float:
        return self.get_clock().now().nanoseconds / MILLISECOND

    def fire(self) -> None:
        self.fired.append(self.milliseconds())

    def receive(self, message: Any) -> None:
        self.received.append((self.milliseconds(), message.data))

    def subscribe(self, topic: str, qos: Any = 10) -> Any:
        return self.create_subscription(type(number(0.0)), topic, self.receive, qos)

    def advertise(self, topic: str, qos: Any = 10) -> Any:
        return self.create_publisher(type(number(0.0)), topic, qos)
