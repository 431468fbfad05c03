class Example:
    def execute(self speed):
        return {}
