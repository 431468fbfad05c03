package dev.eventchain.dds;

/**
 * A status event of a writer or a reader.
 *
 * @param count number of occurrences since the last query
 * @param policy for {@link Kind#INCOMPATIBLE_QOS} the policy of the last mismatch, as {@link
 *     dev.eventchain.messages.QosSettings.Incompatibility} calls it, or its DDS name if ROS 2 does
 *     not set it; otherwise empty
 */
public record DdsEvent(Kind kind, int count, String policy) {

  /** Kinds of events. */
  public enum Kind {
    /** The remote endpoint was found, but its QoS is incompatible. */
    INCOMPATIBLE_QOS,
    /** No sample was received, or written, within the deadline. */
    DEADLINE_MISSED,
    /** For readers: a writer was silent for longer than its lease. For writers: this writer was. */
    LIVELINESS_LOST,
    /** A writer is alive again, or a new one was found. */
    LIVELINESS_GAINED,
    /**
     * Samples were lost although they were sent again. Cyclone does not count gaps of best-effort
     * writers.
     */
    SAMPLE_LOST
  }
}
