package dev.eventchain.sandbox;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The state of a process on Linux (proc(5), third field of {@code stat}).
 *
 * @param letter {@code R} for running, {@code T} for stopped and so on; a blank if unknown
 */
record ProcessState(char letter) {

  /** Returns the current state of a process. */
  static ProcessState of(long pid) {
    try {
      String line = Files.readString(Path.of("/proc", Long.toString(pid), "stat"));
      // The process name before it is in parentheses, and may contain parentheses.
      int end = line.lastIndexOf(')');
      return new ProcessState(end < 0 || end + 2 >= line.length() ? ' ' : line.charAt(end + 2));
    } catch (IOException e) {
      return new ProcessState(' ');
    }
  }

  /** Returns whether a signal, or a debugger, has stopped it. */
  boolean isStopped() {
    return letter == 'T' || letter == 't';
  }
}
