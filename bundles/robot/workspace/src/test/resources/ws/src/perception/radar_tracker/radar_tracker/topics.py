PREFIX = "radar"
TARGET = f"{PREFIX}/target"
