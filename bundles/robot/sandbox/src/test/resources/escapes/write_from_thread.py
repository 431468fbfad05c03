import sys, threading
thread = threading.Thread(target=lambda: open(sys.argv[1] + "/written", "w").write("x"))
thread.start()
thread.join()
