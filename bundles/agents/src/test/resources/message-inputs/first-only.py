class Nearest_Echo:
    """The distance of the first echo ahead, in m; 10 m if there is none."""

    def execute(self, echoes):
        ahead = (float(echo.distance) for echo in echoes if echo.place.x > 0.0)
        return {"nearest": next((distance for distance in ahead if 0.0 <= distance < 10.0), 10.0)}
