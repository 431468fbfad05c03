package dev.eventchain.sandbox;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * What Linux says that a process does (proc(5), third field of {@code stat}).
 *
 * @param letter {@code R} for running, {@code T} for stopped and so on; a blank where Linux does
 *     not say it
 */
record ProcessState(char letter) {

  /** Of a process now. */
  static ProcessState of(long pid) {
    try {
      String line = Files.readString(Path.of("/proc", Long.toString(pid), "stat"));
      // The name before it is in parentheses, and may hold some.
      int end = line.lastIndexOf(')');
      return new ProcessState(end < 0 || end + 2 >= line.length() ? ' ' : line.charAt(end + 2));
    } catch (IOException e) {
      return new ProcessState(' ');
    }
  }

  /** Whether a signal, or a debugger, has stopped it. */
  boolean isStopped() {
    return letter == 'T' || letter == 't';
  }
}
