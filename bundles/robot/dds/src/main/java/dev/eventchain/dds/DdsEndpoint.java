package dev.eventchain.dds;

import dev.eventchain.messages.QosSettings;
import java.time.Duration;
import java.util.HexFormat;
import java.util.Set;

/**
 * A writer or a reader of one topic. Those of other participants that match it are of the other
 * side. Thread-safe.
 */
public abstract sealed class DdsEndpoint implements AutoCloseable permits DdsReader, DdsWriter {

  private final DdsParticipant participant;
  private final DdsTopic topic;
  private final Side side;
  private final int handle;
  private final byte[] gid;

  DdsEndpoint(DdsParticipant participant, DdsTopic topic, Side side, QosSettings qos) {
    this.participant = participant;
    this.topic = topic;
    this.side = side;
    handle = topic.create(participant, qos, side);
    gid = topic.gid(handle);
  }

  static String hex(byte[] guid) {
    return HexFormat.of().formatHex(guid);
  }

  /** Returns the name of the topic in ROS 2. */
  public final String topic() {
    return topic.name();
  }

  /** Returns its GUID, as hexadecimal digits: no other endpoint ever has the same. */
  public final String guid() {
    return hex(gid);
  }

  final byte[] gid() {
    return gid.clone();
  }

  final Side side() {
    return side;
  }

  final int handle() {
    return handle;
  }

  final Cyclone cyclone() {
    return topic.cyclone();
  }

  final DdsTopic ddsTopic() {
    return topic;
  }

  /**
   * Returns the number of matched endpoints.
   *
   * @throws IllegalStateException if this is closed
   */
  public final synchronized int matched() {
    requireOpen();
    return topic.matched(handle, side, null, 0);
  }

  /**
   * Waits until endpoints are matched.
   *
   * @return false if there are fewer after the timeout
   * @throws IllegalStateException if this is, or gets, closed
   */
  public final boolean waitForMatches(int count, Duration timeout) {
    return Matches.await(() -> matched() >= count, timeout);
  }

  /**
   * Waits until certain endpoints are matched.
   *
   * @param guids their GUIDs, as {@link #guid}
   * @return false if one is not after the timeout
   * @throws IllegalStateException if this is, or gets, closed
   */
  public final boolean waitForPeers(Set<String> guids, Duration timeout) {
    return Matches.await(() -> peers().containsAll(guids), timeout);
  }

  private synchronized Set<String> peers() {
    requireOpen();
    return topic.peers(handle, side);
  }

  final void requireOpen() {
    if (isClosing()) {
      throw new IllegalStateException("The " + side.word() + " of " + topic.name() + " is closed.");
    }
  }

  /** Returns whether it is closed or about to be; called with its lock. */
  abstract boolean isClosing();

  /** Tells the participant that the library has deleted it. */
  final void forget() {
    participant.removed(this);
  }

  @Override
  public abstract void close();
}
