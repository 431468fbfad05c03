package dev.eventchain.simulation.host;

import dev.eventchain.simulation.host.NodeSession.Inbound;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;

/**
 * Frames between a host of nodes and its driver, over a pair of streams: u32 length of the rest, u8
 * kind, payload; all numbers little-endian.
 */
public final class HostChannel {

  public static final int CONFIGURE = 1;
  public static final int READY = 2;
  static final int STEP = 3;
  static final int STEPPED = 4;
  public static final int FINISH = 5;
  public static final int FINISHED = 6;
  public static final int FAILED = 7;
  public static final int RESET = 8;
  public static final int CONNECT = 9;
  public static final int CONNECTED = 10;
  public static final int PUBLISH = 11;
  public static final int RUN = 12;
  public static final int IDLE = 13;
  public static final int START = 14;
  public static final int STOP = 15;

  /** Maximum length of a frame; longer ones violate the protocol. */
  private static final int LONGEST = 1 << 25;

  private static final int HEADER = 5;

  /** A frame from the other side. */
  public record Frame(int kind, ByteBuffer payload) {

    public byte[] bytes() {
      byte[] bytes = new byte[payload.remaining()];
      payload.duplicate().get(bytes);
      return bytes;
    }
  }

  /** Violation of the protocol by the other side. */
  public static final class GarbageException extends IOException {
    private static final long serialVersionUID = 1L;

    GarbageException(String message) {
      super(message);
    }
  }

  private final DataInputStream input;
  private final OutputStream output;

  public HostChannel(InputStream input, OutputStream output) {
    this.input = new DataInputStream(input);
    this.output = output;
  }

  /** Sends a complete frame. */
  public void send(int kind, byte[] payload) throws IOException {
    byte[] frame = new byte[HEADER + payload.length];
    header(frame, kind).put(payload);
    write(frame);
  }

  /** Sends the messages of an instant and advances time. */
  void sendStep(long until, List<Inbound> messages) throws IOException {
    int length = HEADER + Long.BYTES + Short.BYTES;
    for (Inbound message : messages) {
      length += Short.BYTES + Integer.BYTES + message.message().remaining();
    }
    byte[] frame = new byte[length];
    ByteBuffer buffer = header(frame, STEP);
    buffer.putLong(until).putShort((short) messages.size());
    for (Inbound message : messages) {
      buffer.putShort((short) message.topic()).putInt(message.message().remaining());
      buffer.put(message.message().duplicate());
    }
    write(frame);
  }

  /** Sends a frame that holds a time. */
  public void sendTime(int kind, long time) throws IOException {
    byte[] frame = new byte[HEADER + Long.BYTES];
    header(frame, kind).putLong(time);
    write(frame);
  }

  private static ByteBuffer header(byte[] frame, int kind) {
    ByteBuffer buffer = ByteBuffer.wrap(frame).order(ByteOrder.LITTLE_ENDIAN);
    return buffer.putInt(frame.length - Integer.BYTES).put((byte) kind);
  }

  private void write(byte[] frame) throws IOException {
    output.write(frame);
    output.flush();
  }

  /**
   * Waits for the next frame.
   *
   * @throws EOFException the other side has ended
   * @throws GarbageException what arrived is not a frame
   */
  public Frame receive() throws IOException {
    byte[] header = new byte[HEADER];
    input.readFully(header);
    ByteBuffer numbers = ByteBuffer.wrap(header).order(ByteOrder.LITTLE_ENDIAN);
    int length = numbers.getInt();
    int kind = numbers.get();
    if (length < 1 || length > LONGEST || kind < CONFIGURE || kind > STOP) {
      throw new GarbageException("a frame of kind " + kind + " with length " + length);
    }
    byte[] payload = new byte[length - 1];
    input.readFully(payload);
    return new Frame(kind, ByteBuffer.wrap(payload).order(ByteOrder.LITTLE_ENDIAN));
  }
}
