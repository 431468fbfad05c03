class Time_Left:
    def execute(self, distances, speed):
        return {"time_left": 1000.0}


component = Time_Left()
print(component.execute([10.0], 2.0))
