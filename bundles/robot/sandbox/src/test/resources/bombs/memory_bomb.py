held = []
while True:
    try:
        held.append(bytearray(1 << 20))
    except MemoryError:
        pass
