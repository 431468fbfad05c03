class Lane_Detection:
    def execute(self, brightness):
        return {"offset": brightness + 1.0}
