package dev.eventchain.simulation.tracing;

import dev.eventchain.diagnostics.SourceLocation;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.StringReader;
import java.util.Locale;

/** Text of a trace by hand, in the form of babeltrace2. Times are in ms since an hour. */
final class TraceText {

  private static final long HOUR = 1_795_958_000_000_000_000L;

  private final StringBuilder text = new StringBuilder("Stream beginning:\n  Name: c_0\n\n");
  private int thread = 1;
  private int trace;
  private String namespace = "";

  /** Returns a time in ns since 1970. */
  static long at(double milliseconds) {
    return HOUR + Math.round(milliseconds * 1e6);
  }

  /** Lets the next events occur in a thread. */
  TraceText in(int other) {
    thread = other;
    return this;
  }

  /** Lets the next events occur in a namespace of ids. */
  TraceText inside(long number) {
    namespace = "\n    pid_ns: " + number(number);
    return this;
  }

  /** Lets the next events be those of another machine or container. */
  TraceText on(int number, String host) {
    trace = number;
    String head =
        String.format(Locale.ROOT, "{Trace %d, Stream class ID 0, Stream ID 0}\n", number);
    return message(head + "Stream beginning:\n    Environment (1 entry):\n      hostname: " + host)
        .message("Stream end");
  }

  /** Lets the next events be those of the first process again. */
  TraceText back() {
    trace = 0;
    namespace = "";
    return this;
  }

  /** Adds an event; fields are pairs of a name and a value. */
  TraceText event(double time, String name, Object... fields) {
    text.append("[1,000 cycles, %s ns from origin]\n".formatted(number(at(time))));
    text.append(String.format(Locale.ROOT, "{Trace %d, Stream class ID 0, Stream ID 0}\n", trace));
    text.append("Event `ros2:").append(name).append("` (Class ID 1):\n");
    text.append("  Common context:\n    vpid: 16,022\n    vtid: ").append(thread).append(namespace);
    text.append("\n    procname: record\n  Payload:\n");
    for (int i = 0; i < fields.length; i += 2) {
      Object value = fields[i + 1] instanceof Long number ? number(number) : fields[i + 1];
      text.append("    ").append(fields[i]).append(": ").append(value).append('\n');
    }
    text.append('\n');
    return this;
  }

  private static String number(long number) {
    return String.format(Locale.ROOT, "%,d", number);
  }

  /** Adds a node with a topic that it reads and one that it writes; an empty one for none. */
  TraceText node(int id, String name, String space, String in, String out) {
    event(0, "rcl_node_init", "node_handle", id + "0", "node_name", name, "namespace", space);
    if (!out.isEmpty()) {
      String handle = "publisher_handle";
      event(0, "rcl_publisher_init", handle, id + "1", "node_handle", id + "0", "topic_name", out);
    }
    if (!in.isEmpty()) {
      event(
          0,
          "rcl_subscription_init",
          "subscription_handle",
          id + "2",
          "node_handle",
          id + "0",
          "rmw_subscription_handle",
          id + "3",
          "topic_name",
          in);
    }
    return this;
  }

  /** Adds the callback of a node's subscription, and its timer. */
  TraceText callbacks(int id) {
    String handle = "subscription_handle";
    event(0, "rclcpp_subscription_init", handle, id + "2", "subscription", id + "4");
    String added = "rclcpp_subscription_callback_added";
    event(0, added, "subscription", id + "4", "callback", id + "5");
    event(0, "rcl_timer_init", "timer_handle", id + "6", "period", 20_000_000L);
    event(0, "rclcpp_timer_callback_added", "timer_handle", id + "6", "callback", id + "7");
    return event(0, "rclcpp_timer_link_node", "timer_handle", id + "6", "node_handle", id + "0");
  }

  /** A node publishes; the message carries a time, or none is recorded. */
  TraceText publish(double time, int id, double... stamp) {
    event(time, "rcl_publish", "publisher_handle", id + "1", "message", "0x1:0000");
    return stamp.length == 0
        ? event(time, "rmw_publish", "message", "0x1:0000")
        : event(time, "rmw_publish", "message", "0x1:0000", "timestamp", at(stamp[0]));
  }

  /** A node takes the message that carries a time. */
  TraceText take(double time, int id, double stamp) {
    return event(
        time,
        "rmw_take",
        "rmw_subscription_handle",
        id + "3",
        "source_timestamp",
        at(stamp),
        "taken",
        1);
  }

  /** The callback of a node's subscription starts, or that of its timer. */
  TraceText start(double time, int id, boolean timer) {
    String callback = id + (timer ? "7" : "5");
    return event(time, "callback_start", "callback", callback, "is_intra_process", 0);
  }

  /** The same callback ends. */
  TraceText end(double time, int id, boolean timer) {
    return event(time, "callback_end", "callback", id + (timer ? "7" : "5"));
  }

  /** Adds a message of babeltrace2. */
  TraceText message(String lines) {
    text.append(lines).append("\n\n");
    return this;
  }

  /** Reads the trace. */
  RecordedTrace read() {
    return read(text + "[Unknown]\nStream end\n");
  }

  /** Reads a text. */
  static RecordedTrace read(String text) {
    try {
      return RecordedTrace.read(
          new BufferedReader(new StringReader(text)), SourceLocation.of("trace.txt"));
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }
}
