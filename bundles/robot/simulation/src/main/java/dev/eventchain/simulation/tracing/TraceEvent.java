package dev.eventchain.simulation.tracing;

import java.util.Map;

/**
 * An event of a recorded trace.
 *
 * @param time in ns since 1970
 * @param name with its provider, such as {@code ros2:callback_start}
 * @param process in which it occurred
 * @param thread id of the thread in the namespace of its process
 * @param fields values of the payload as texts, by name
 */
record TraceEvent(
    long time, String name, ProcessId process, long thread, Map<String, String> fields) {

  /**
   * A process: ids are those of a container, and several containers have the same ones.
   *
   * @param host the name of the machine or container; empty if it was not recorded
   * @param namespace the namespace of ids, by a number; empty if it was not recorded
   */
  record ProcessId(String host, String namespace, long id) {}

  /** An object of a process by its address, which another one may have later. */
  record Handle(ProcessId process, String address) {}

  /** A thread of a process. */
  record ThreadId(ProcessId process, long thread) {}

  /** Copies the fields. */
  TraceEvent {
    fields = Map.copyOf(fields);
  }

  /** Returns a field; empty if there is none. */
  String text(String field) {
    return fields.getOrDefault(field, "");
  }

  /** Returns a field as a number; 0 if it is none. */
  long number(String field) {
    try {
      return Long.parseLong(text(field));
    } catch (NumberFormatException e) {
      return 0;
    }
  }

  /** Returns the object whose address a field has. */
  Handle handle(String field) {
    return new Handle(process, text(field));
  }

  /** Returns the thread in which it occurred. */
  ThreadId threadId() {
    return new ThreadId(process, thread);
  }
}
