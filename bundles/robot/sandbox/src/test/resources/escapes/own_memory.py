memory = open("/proc/self/mem", "r+b", buffering=0)
print("ESCAPED")
