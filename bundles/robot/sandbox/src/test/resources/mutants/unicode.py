class Example:
    def execute(self, straße):
        text, speed = "äöü 🚗", straße - 1.5; other = "🚗" + text if speed < 2.0 else speed
        return {"speed": speed, "other": other}
