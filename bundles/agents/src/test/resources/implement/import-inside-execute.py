class Time_Left:
    def execute(self, distances, speed):
        import rclpy.logging

        return {"time_left": 1000.0}
