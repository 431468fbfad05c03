package dev.eventchain.dds;

import com.sun.jna.Memory;
import com.sun.jna.Pointer;
import com.sun.jna.ptr.PointerByReference;
import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.QosSettings;
import java.util.List;

/** A writer of messages of one topic. Thread-safe: calls are serialized. */
public final class DdsWriter extends DdsEndpoint {

  /** Offset of {@code ddsi_serdata.timestamp}, checked by {@link LayoutCheck}. */
  static final long SOURCE_TIMESTAMP = 32;

  private static final int DATA = 2;
  private static final int VECTOR_SIZE = 16;

  private final Pointer serialType;
  private final Memory vector = new Memory(VECTOR_SIZE);
  private Memory buffer = new Memory(4096);
  private boolean closed;

  DdsWriter(DdsParticipant participant, DdsTopic topic, QosSettings qos) {
    super(participant, topic, Side.WRITER, qos);
    PointerByReference type = new PointerByReference();
    topic.check(topic.cyclone().getEntitySertype(handle(), type), "describe the type");
    serialType = type.getValue();
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
    return isTaken(Samples.writecdr(handle(), data));
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
    return isTaken(Samples.forwardcdr(handle(), data));
  }

  private boolean isTaken(int result) {
    if (result == Codes.TIMEOUT) {
      return false;
    }
    ddsTopic().check(result, "write a sample");
    return true;
  }

  /** Returns the bytes as a sample in the library's memory. */
  synchronized Pointer serialized(byte[] cdr) {
    requireOpen();
    // The library does not report bytes beyond the message.
    CdrCodec.requireMessage(ddsTopic().type(), cdr);
    if (cdr.length > buffer.size()) {
      buffer = new Memory(cdr.length * 2L);
    }
    buffer.write(0, cdr, 0, cdr.length);
    vector.setPointer(0, buffer);
    vector.setLong(Long.BYTES, cdr.length);
    Pointer data = Samples.ddsiSerdataFromSerIov(serialType, DATA, 1, vector, cdr.length);
    if (data == null) {
      throw new IllegalArgumentException(
          "The bytes are not a message of the type " + ddsTopic().type() + ".");
    }
    return data;
  }

  /** Returns the events since the last call. */
  public synchronized List<DdsEvent> events() {
    requireOpen();
    return Statuses.ofWriter(cyclone(), handle());
  }

  /** Asserts the liveliness of this writer, for readers that request liveliness by topic. */
  public synchronized void assertLiveliness() {
    requireOpen();
    ddsTopic().check(cyclone().assertLiveliness(handle()), "assert the liveliness");
  }

  @Override
  synchronized boolean isClosing() {
    return closed;
  }

  /** Closes it; samples that are not yet acknowledged are lost. */
  @Override
  public void close() {
    synchronized (this) {
      if (closed) {
        return;
      }
      closed = true;
      cyclone().delete(handle());
    }
    forget();
  }
}
