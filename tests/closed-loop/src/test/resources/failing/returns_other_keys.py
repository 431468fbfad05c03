"""Wrong on purpose: its result has another name."""


class Braking_Decision:
    def execute(self, time_to_collision):
        return {"force": 0.0}
