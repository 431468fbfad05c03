import multiprocessing
if __name__ == "__main__":
    worker = multiprocessing.get_context("fork").Process(target=print)
    worker.start()
    print("ESCAPED")
