package dev.eventchain.dds;

import com.sun.jna.Memory;
import com.sun.jna.Pointer;
import com.sun.jna.ptr.PointerByReference;
import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.QosSettings;
import java.time.Duration;
import java.util.List;
import java.util.Set;

/** A writer of messages of one topic. Thread-safe: calls are serialized. */
public final class DdsWriter implements AutoCloseable {

  /** Offset of {@code ddsi_serdata.timestamp}, checked by {@link LayoutCheck}. */
  static final long SOURCE_TIMESTAMP = 32;

  private static final int DATA = 2;
  private static final int VECTOR_SIZE = 16;

  private final DdsParticipant participant;
  private final Endpoint endpoint;
  private final int handle;
  private final byte[] gid;
  private final Pointer serialType;
  private final Memory vector = new Memory(VECTOR_SIZE);
  private Memory buffer = new Memory(4096);
  private boolean closed;

  DdsWriter(DdsParticipant participant, Endpoint endpoint, QosSettings qos) {
    this.participant = participant;
    this.endpoint = endpoint;
    handle = endpoint.create(participant, qos, true);
    gid = endpoint.gid(handle);
    PointerByReference type = new PointerByReference();
    endpoint.check(endpoint.cyclone().getEntitySertype(handle, type), "describe the type");
    serialType = type.getValue();
  }

  /** Returns the topic. */
  public String topic() {
    return endpoint.topic();
  }

  byte[] gid() {
    return gid.clone();
  }

  /** Returns its GUID, as hexadecimal digits: no other endpoint ever has the same. */
  public String guid() {
    return Endpoint.hex(gid);
  }

  /**
   * Writes a message with the current time.
   *
   * @param cdr the message as {@link CdrCodec} writes it, header included
   * @return false if reliable readers have not acknowledged earlier samples for 100 ms; this one
   *     was not sent then
   * @throws IllegalArgumentException if the bytes are not a message of the type
   * @throws IllegalStateException if the writer is closed
   */
  public synchronized boolean write(byte[] cdr) {
    Pointer data = serialized(cdr);
    return isTaken(Samples.writecdr(handle, data));
  }

  /**
   * Writes a message with a given source timestamp.
   *
   * @param sourceTimestamp the time that readers see, in ns, not negative
   * @return as {@link #write(byte[])}
   * @throws IllegalArgumentException as {@link #write(byte[])}, and for a negative time
   * @throws IllegalStateException if the writer is closed
   */
  public synchronized boolean write(byte[] cdr, long sourceTimestamp) {
    if (sourceTimestamp < 0) {
      throw new IllegalArgumentException(
          "A source timestamp must not be negative: " + sourceTimestamp);
    }
    Pointer data = serialized(cdr);
    data.setLong(SOURCE_TIMESTAMP, sourceTimestamp);
    return isTaken(Samples.forwardcdr(handle, data));
  }

  private boolean isTaken(int result) {
    if (result == Codes.TIMEOUT) {
      return false;
    }
    endpoint.check(result, "write a sample");
    return true;
  }

  /** Returns the bytes as a sample in the library's memory. */
  synchronized Pointer serialized(byte[] cdr) {
    requireOpen();
    // The library does not report bytes beyond the message.
    CdrCodec.requireMessage(endpoint.type(), cdr);
    if (cdr.length > buffer.size()) {
      buffer = new Memory(cdr.length * 2L);
    }
    buffer.write(0, cdr, 0, cdr.length);
    vector.setPointer(0, buffer);
    vector.setLong(Long.BYTES, cdr.length);
    Pointer data = Samples.ddsiSerdataFromSerIov(serialType, DATA, 1, vector, cdr.length);
    if (data == null) {
      throw new IllegalArgumentException(
          "The bytes are not a message of the type " + endpoint.type() + ".");
    }
    return data;
  }

  /** Returns the number of matched readers. */
  public synchronized int matched() {
    requireOpen();
    return endpoint.matched(handle, true, null, 0);
  }

  /**
   * Waits until readers are matched.
   *
   * @return false if there are fewer after the timeout
   * @throws IllegalStateException if the writer is, or gets, closed
   */
  public boolean waitForMatches(int count, Duration timeout) {
    return Matches.await(() -> matched() >= count, timeout);
  }

  /**
   * Waits until certain readers are matched.
   *
   * @param guids their GUIDs, as {@link #guid}
   * @return false if one is not after the timeout
   * @throws IllegalStateException if this is, or gets, closed
   */
  public boolean waitForPeers(Set<String> guids, Duration timeout) {
    return Matches.await(() -> peers().containsAll(guids), timeout);
  }

  private synchronized Set<String> peers() {
    requireOpen();
    return endpoint.peers(handle, true);
  }

  /** Returns the events since the last call. */
  public synchronized List<DdsEvent> events() {
    requireOpen();
    return Statuses.ofWriter(endpoint.cyclone(), handle);
  }

  /** Asserts the liveliness of this writer, for readers that request liveliness by topic. */
  public synchronized void assertLiveliness() {
    requireOpen();
    endpoint.check(endpoint.cyclone().assertLiveliness(handle), "assert the liveliness");
  }

  private void requireOpen() {
    if (closed) {
      throw new IllegalStateException("The writer of " + endpoint.topic() + " is closed.");
    }
  }

  /** Closes it; samples that are not yet acknowledged are lost. */
  @Override
  public void close() {
    synchronized (this) {
      if (closed) {
        return;
      }
      closed = true;
      endpoint.cyclone().delete(handle);
    }
    participant.removed(this, gid);
  }
}
