"""Wrong on purpose: a bracket is missing."""


class Braking_Decision:
    def execute(self, time_to_collision):
        return {"braking_force": 0.0
