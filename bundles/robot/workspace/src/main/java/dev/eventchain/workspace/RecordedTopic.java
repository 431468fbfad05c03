package dev.eventchain.workspace;

import dev.eventchain.messages.QosSettings;
import java.util.Optional;

/**
 * A topic of a recording.
 *
 * @param qos what the first of its publishers offered; empty if the recording does not say
 * @param count the number of messages
 * @param rate in Hz, on average; 0 if it is not known
 * @param file the file that says so
 */
record RecordedTopic(
    String name, String type, Optional<QosSettings> qos, long count, double rate, String file) {

  /** Returns the average rate of messages over a time in s; 0 for fewer than two. */
  static double rate(long count, double duration) {
    return count > 1 && duration > 0 ? Math.round(10 * (count - 1) / duration) / 10.0 : 0;
  }
}
