class Vehicle_Control:
    """Does nothing."""
