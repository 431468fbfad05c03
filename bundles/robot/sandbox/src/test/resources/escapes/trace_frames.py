# escapes from: bubblewrap_without_hooks
# escapes from: kernel_without_hooks
import sys
sys.settrace(lambda frame, event, argument: None)
print("ESCAPED")
