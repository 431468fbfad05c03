KEY = "ttc"


class TTC:
    def execute(self, distance, speed):
        def inner():
            return {"other": 1}

        if speed < 0:
            return {**inner(), KEY: 1.0}
        result = {}
        result[KEY] = distance
        return result
