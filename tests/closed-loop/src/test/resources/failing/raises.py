"""Wrong on purpose: it raises when something comes near."""


class Braking_Decision:
    def execute(self, time_to_collision):
        return {"braking_force": 0.0 if time_to_collision > 3.0 else [0.5][1]}
