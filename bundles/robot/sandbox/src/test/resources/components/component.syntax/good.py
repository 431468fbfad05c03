# Umlauts and symbols are fine: τ = d / v, Zeit bis zum Aufprall in s, größer als null.
class TTC:
    """Time to collision."""

    def execute(self, distance: float, speed: float) -> dict[str, float]:
        return {"ttc": distance / max(speed, 0.1)}
