class Example:
    def execute(self, speed, ranges):
        if speed:
            return {"active": True, "ranges": ranges}

        def inner():
            return speed

        result = {"active": inner(), "ranges": ranges}
        return result
