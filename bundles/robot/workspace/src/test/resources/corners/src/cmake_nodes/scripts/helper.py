TRUE = True
