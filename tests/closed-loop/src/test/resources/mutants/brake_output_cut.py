"""Wrong on purpose: the brake output is cut."""

import math


class Carla_Vehicle_Control:
    """Maps the normalized braking force to the brake pedal of a CARLA ego vehicle."""

    def execute(self, braking_force):
        """Take a force of 0.0 (none) to 1.0 (full); values outside are limited.

        Returns the pedals, the steering and the gear selection of CarlaEgoVehicleControl. Raises
        ValueError when the force is not a number: neither braking nor rolling on would be a safe guess.
        """
        if math.isnan(braking_force):
            raise ValueError("braking_force is not a number")
        return {
            "throttle": 0.0,
            "steer": 0.0,
            "brake": 0.0,
            "hand_brake": False,
            "reverse": False,
        }
