"""Wrong on purpose: its result is not a number."""


class Braking_Decision:
    def execute(self, time_to_collision):
        return {"braking_force": float("nan")}
