class Example:
    """Each pair counts in its order."""

    def execute(self, front_door, rear_door, left_door, driver_seat, middle_seat, left_gap, right_gap, left_speed, right_speed):
        """Take Booleans, texts, m and m/s."""
        seats = [driver_seat, middle_seat]
        first = front_door or (left_gap / right_gap > 2.0)
        if left_door and not rear_door:
            first = False
        return {
            "open": first or rear_door,
            "occupied": any(seat == "OCCUPIED" for seat in seats),
            "first": seats[0],
            "gap": left_gap or right_gap,
            "moving": left_speed > 0.0 and 1.0 / left_speed > right_speed,
        }
