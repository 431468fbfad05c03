class TTC:
    async def execute(self, distance, speed):
        return {"ttc": distance / speed}
