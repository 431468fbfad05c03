class Time_Left:
    def execute(self, inputs):
        return {"time_left": inputs["speed"]}
