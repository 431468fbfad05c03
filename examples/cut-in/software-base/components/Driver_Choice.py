"""Which driver the vehicle follows (an existing component)."""


class Driver_Choice:
    """Passes on what the chosen driver asks for: 1 CC, 2 Reg157, 3 RSS, 4 FSM."""

    def execute(self, model, cc, reg157, rss, fsm):
        """Take decelerations in m/s2; return the acceleration in m/s2."""
        return {"acceleration": -{1: cc, 2: reg157, 3: rss, 4: fsm}[model]}
