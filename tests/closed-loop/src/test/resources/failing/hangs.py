"""Wrong on purpose: it never returns."""


class Braking_Decision:
    def execute(self, time_to_collision):
        try:
            while True: pass
        except Exception:
            return {"braking_force": 0.0}
