"""Wrong on purpose: it returns the force itself."""


class Braking_Decision:
    def execute(self, time_to_collision):
        return 0.0
