package dev.eventchain.simulation.tracing;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.tracing.TraceEvent.ProcessId;
import dev.eventchain.simulation.tracing.TraceEvent.ThreadId;
import java.io.BufferedReader;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A recorded trace of ROS 2 nodes, read from the text of {@code babeltrace2
 * --component=sink.text.details}. Of its outputs, this one alone also has the events that were
 * lost, and the ends of streams, by which a text that was cut off is noticed.
 */
public final class RecordedTrace {

  /** The options of babeltrace2 before the folder of the trace. */
  public static final List<String> OPTIONS = List.of("--component=sink.text.details");

  private static final String HINT =
      "Name a folder that 'ros2 trace' or LTTng has written, or the text of: babeltrace2 "
          + String.join(" ", OPTIONS)
          + " FOLDER > trace.txt";

  private static final Pattern TIME = Pattern.compile("\\[.*?([-0-9,]+) ns from origin\\]");
  private static final Pattern TRACE = Pattern.compile("\\{Trace ([0-9]+),.*");
  private static final Pattern HOST = Pattern.compile(" +hostname: (.*)");
  private static final Pattern EVENT = Pattern.compile("Event `([^`]+)`.*");
  private static final Pattern LOST =
      Pattern.compile("Discarded (events|packets)(?: \\(([0-9,]+) .*\\))?");
  private static final Pattern FIELD = Pattern.compile(" {4}([A-Za-z_0-9]+): ?(.*)");
  private static final Pattern NUMBER =
      Pattern.compile("-?[0-9]{1,3}(?:,[0-9]{3})*|0x[0-9a-f]+(?::[0-9a-f]{4})*");
  private static final Pattern SEPARATOR = Pattern.compile("[,:]");
  private static final String NO_LOSSES = "Supports discarded events: No";

  private final SourceLocation place;
  private final ActivityReader reader = new ActivityReader();
  private final Map<String, Long> discarded = new HashMap<>();
  private final Set<String> lost = new TreeSet<>();

  /** The names of the machines or containers, by the numbers of their traces. */
  private final Map<String, String> hosts = new HashMap<>();

  private long events;
  private int begun;
  private int ended;

  /** The lines of the current message. */
  private final List<String> message = new ArrayList<>();

  private RecordedTrace(SourceLocation place) {
    this.place = place;
  }

  /**
   * Reads a trace.
   *
   * @param place its file or folder, for findings
   * @throws DiagnosticException INPUT, {@code trace.unreadable}, if it is none, is cut off, or says
   *     of no thread which events it has
   * @throws IOException if it cannot be read
   */
  public static RecordedTrace read(BufferedReader text, SourceLocation place) throws IOException {
    RecordedTrace trace = new RecordedTrace(place);
    for (String line = text.readLine(); line != null; line = text.readLine()) {
      if (line.isEmpty()) {
        trace.endMessage();
      } else {
        trace.message.add(line);
      }
    }
    trace.endMessage();
    trace.check();
    return trace;
  }

  /** Returns the failure to read a trace. */
  public static DiagnosticException unreadable(String reason, SourceLocation place) {
    String message = "This trace cannot be read: " + reason.replaceAll("\\.$", "") + ".";
    return new DiagnosticException(
        Reason.INPUT, Diagnostic.of(TracingRules.TRACE_UNREADABLE, message, place).withHint(HINT));
  }

  private void check() {
    if (begun == 0) {
      throw unreadable("it has no streams in the form of sink.text.details", place);
    }
    if (begun != ended) {
      throw unreadable(
          String.format(Locale.ROOT, "it is cut off, since %d of %d streams end", ended, begun),
          place);
    }
    discarded.forEach((kind, count) -> lost.add(count + " " + kind));
  }

  private void endMessage() {
    Long time = null;
    String trace = "";
    for (int i = 0; i < message.size(); i++) {
      String line = message.get(i);
      Matcher stamp = TIME.matcher(line);
      Matcher event = EVENT.matcher(line);
      Matcher discard = LOST.matcher(line);
      Matcher source = TRACE.matcher(line);
      Matcher host = HOST.matcher(line);
      if (stamp.lookingAt()) {
        time = number(stamp.group(1));
      } else if (source.matches()) {
        trace = source.group(1);
      } else if (event.matches()) {
        event(event.group(1), time, trace, message.subList(i + 1, message.size()));
        break;
      } else if (host.matches()) {
        hosts.put(trace, host.group(1));
      } else if (discard.matches()) {
        discard(discard);
      } else {
        stream(line);
      }
    }
    message.clear();
  }

  /** Reads a line about a stream, if it is one. */
  private void stream(String line) {
    if (line.startsWith("Stream beginning")) {
      begun++;
    } else if (line.startsWith("Stream end")) {
      ended++;
    } else if (line.contains(NO_LOSSES)) {
      lost.add("a stream does not count them");
    }
  }

  private void discard(Matcher discard) {
    if (discard.group(2) == null) {
      lost.add("an unknown number of " + discard.group(1));
    } else {
      discarded.merge(discard.group(1), number(discard.group(2)), Long::sum);
    }
  }

  private long number(String text) {
    try {
      return Long.parseLong(plain(text));
    } catch (NumberFormatException e) {
      throw unreadable("'" + Printable.line(text) + "' is no number that it can have", place);
    }
  }

  private static String plain(String number) {
    return SEPARATOR.matcher(number).replaceAll("");
  }

  private void event(String name, Long time, String trace, List<String> lines) {
    events++;
    if (!name.startsWith("ros2:")) {
      return;
    }
    if (time == null) {
      throw unreadable("an event '" + name + "' has no time in ns", place);
    }
    Map<String, String> context = new HashMap<>();
    Map<String, String> fields = new HashMap<>();
    Map<String, String> block = context;
    for (String line : lines) {
      Matcher field = FIELD.matcher(line);
      if (line.startsWith("  Payload")) {
        block = fields;
      } else if (field.matches()) {
        block.put(field.group(1), value(field.group(2)));
      }
    }
    String host = hosts.getOrDefault(trace, "");
    String namespace = context.getOrDefault("pid_ns", "");
    ProcessId process = new ProcessId(host, namespace, id(context, "vpid"));
    reader.read(new TraceEvent(time, name, process, id(context, "vtid"), fields));
  }

  /** Returns a value without the separators that numbers have for people. */
  private static String value(String text) {
    return NUMBER.matcher(text).matches() ? plain(text) : text;
  }

  private long id(Map<String, String> context, String name) {
    String value = context.getOrDefault(name, "");
    if (!value.matches("[0-9]{1,10}")) {
      throw unreadable(
          "its events do not say in which thread they occurred; record them with the contexts vpid and vtid, as 'ros2 trace' does",
          place);
    }
    return Long.parseLong(value);
  }

  /** Returns the activity of the nodes. */
  RosActivity activity() {
    return reader.activity();
  }

  /** Returns the number of events, of ROS 2 and others. */
  public long events() {
    return events;
  }

  /** Returns which events were lost, in words; none if all are there. */
  public List<String> lost() {
    return List.copyOf(lost);
  }

  /**
   * Returns the threads whose callbacks overlap, in words: no thread executes two at once, so that
   * several processes have the same ids.
   */
  public List<String> mixed() {
    return activity().mixed.stream().map(RecordedTrace::described).sorted().toList();
  }

  private static String described(ThreadId thread) {
    return String.format(Locale.ROOT, "vpid %d, vtid %d", thread.process().id(), thread.thread());
  }

  /** Returns the full names of all nodes, sorted. */
  public List<String> nodes() {
    return activity().nodes.stream().map(RosActivity.Node::fullName).distinct().sorted().toList();
  }
}
