from demo_srvs.srv import Sum
from rclpy.node import Node
from std_msgs.msg import Int64


class Adder(Node):
    def __init__(self):
        super().__init__("adder")
        self.create_service(Sum, "sum", self.add)

    def add(self, request, response):
        response.sum = request.a + request.b
        return response


class Asker(Node):
    def __init__(self):
        super().__init__("asker")
        self.client = self.create_client(Sum, "sum")
        self.client.wait_for_service()
        self.heard = self.create_publisher(Int64, "/heard", 10)
        self.create_timer(0.1, self.ask)

    async def ask(self):
        answer = await self.client.call_async(Sum.Request(a=40, b=2))
        self.heard.publish(Int64(data=answer.sum))
