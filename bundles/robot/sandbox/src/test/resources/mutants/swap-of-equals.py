class Example:
    """Does the same with any two doors exchanged, but not with two seats."""

    def execute(self, front_door, rear_door, left_door, driver_seat, middle_seat, left_gap, right_gap, left_speed, right_speed):
        """Take Booleans, texts, m and m/s."""
        any_open = front_door or rear_door or left_door
        seats = (driver_seat, middle_seat)
        near = left_gap < 2.0 or right_gap < 2.0
        return {
            "open": bool(any_open and near),
            "occupied": any(seat == "OCCUPIED" for seat in seats),
            "count": sum(seat != "EMPTY" for seat in [driver_seat, middle_seat]),
            "alike": left_gap == right_gap and "UNKNOWN" not in (driver_seat, middle_seat),
            "moving": 1.0 if left_speed and right_speed else 0.0,
        }
