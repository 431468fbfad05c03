# escapes from: bubblewrap_without_hooks
# escapes from: kernel_without_hooks
# control: none
import sys
sys.monitoring.use_tool_id(2, "tool")
sys.monitoring.register_callback(2, sys.monitoring.events.PY_START, lambda code, offset: print("ESCAPED"))
sys.monitoring.set_events(2, sys.monitoring.events.PY_START)
(lambda: None)()
