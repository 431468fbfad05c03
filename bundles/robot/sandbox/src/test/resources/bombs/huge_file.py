with open("huge", "wb") as file:
    while True:
        try:
            file.write(b"x" * (1 << 20))
        except OSError:
            pass
