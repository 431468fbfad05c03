class Brake:
    period = 0.1

    def __init__(self, participant):
        self.participant = participant

    def execute(self):
        pass
