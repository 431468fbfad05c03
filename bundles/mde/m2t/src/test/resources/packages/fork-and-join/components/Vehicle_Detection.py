class Vehicle_Detection:
    def execute(self, second_exposure):
        return {"vehicles": [int(10.0 * second_exposure), 3], "urgent": second_exposure > 1.5}
