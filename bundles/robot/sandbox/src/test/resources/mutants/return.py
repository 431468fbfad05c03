class Example:
    def execute(self, active, values):
        if not active:
            return {"sum": 0.0}
        total = 0.0
        for value in values:
            total = total + value
        self._keep(total)
        return {"sum": total}

    def _keep(self, total):
        """Remember it."""
        self.total = total
        self.last = total
