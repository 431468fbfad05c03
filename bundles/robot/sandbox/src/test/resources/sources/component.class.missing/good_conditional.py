try:
    import numpy as np
except ImportError:
    np = None

if np is None:

    class TTC:
        def execute(self, distance, speed):
            return {"ttc": distance}

else:

    class TTC:
        def execute(self, distance, speed):
            return {"ttc": float(np.float64(distance))}
