"""Wrong on purpose: it prints all that it gets, often."""


class Braking_Decision:
    def execute(self, time_to_collision):
        for _ in range(300):
            print("time to collision: ", time_to_collision, "." * 1000)
        return {"braking_force": 0.0}
