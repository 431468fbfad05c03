# Start of user code imports
import mine
# End of user code
def gone():
    # Start of user code gone
    precious()
    # End of user code
def root():
    # Start of user code root
    return 7
    # End of user code
