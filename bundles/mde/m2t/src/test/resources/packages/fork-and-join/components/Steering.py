class Steering:
    def execute(self, offset, variances, vehicles, urgent):
        assert len(variances) == 36
        angle = offset + 0.25 * vehicles[0] + (100.0 if urgent.data else 0.0)
        return {"angle": angle, "frame": "wheel"}
