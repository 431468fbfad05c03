package dev.eventchain.dds;

/**
 * Something that happened to a writer or a reader.
 *
 * @param count how often since it was last asked for
 * @param policy for {@link Kind#INCOMPATIBLE_QOS} the policy that did not match last, as {@link
 *     dev.eventchain.messages.QosSettings.Incompatibility} calls it, or the name of DDS for one
 *     that ROS 2 does not set; else empty
 */
public record DdsEvent(Kind kind, int count, String policy) {

  /** What happened. */
  public enum Kind {
    /** The other side was found, and offers or wants something else. */
    INCOMPATIBLE_QOS,
    /** No sample came, or was written, within the deadline. */
    DEADLINE_MISSED,
    /** For readers: a writer was silent for longer than its lease. For writers: this one was. */
    LIVELINESS_LOST,
    /** A writer that was not alive is again, or a new one is. */
    LIVELINESS_GAINED,
    /**
     * Samples that were sent again in vain. Gaps of best-effort writers are not counted by Cyclone.
     */
    SAMPLE_LOST
  }
}
