# Start of user code imports
import mine
# End of user code
def trunk():
    # Start of user code trunk
    pass
    # End of user code
def root():
    # Start of user code root
    return 7
    # End of user code
def bird():
    # Start of user code bird
    pass
    # End of user code
# Start of user code tail
# End of user code
