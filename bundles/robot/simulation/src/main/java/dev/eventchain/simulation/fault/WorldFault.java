package dev.eventchain.simulation.fault;

import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageType;
import dev.eventchain.simulation.host.RunLog;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;

/**
 * Effect of a fault on the world's own messages to the nodes and on its clock. Messages of nodes
 * are altered in their process.
 */
public final class WorldFault {

  private static final int CDR_HEADER = 4;

  /** Number of bytes of a message for each altered one. */
  private static final int BYTES_FOR_ONE = 16;

  private static final double MILLION = 1e6;

  private final Optional<Fault> fault;
  private final SplittableRandom random;
  private long affected;
  private long first = RunLog.NEVER;

  public WorldFault(Optional<Fault> fault) {
    this.fault = fault;
    this.random = new SplittableRandom(fault.map(Fault::seed).orElse(0L));
  }

  /** Returns whether a sensor is silent at a time, in ns. */
  public boolean silences(String topic, long now) {
    boolean silent = concerns(topic, now) && fault.get().kind() == FaultKind.DEAD_SENSOR;
    if (silent) {
      touch(now);
    }
    return silent;
  }

  /** Returns the messages that result from one arriving at a time: none, or several in sequence. */
  public List<ByteBuffer> arriving(MessageType type, String topic, long now, ByteBuffer message) {
    if (!concerns(topic, now)) {
      return List.of(message);
    }
    return switch (fault.get().kind()) {
      case DROP -> {
        boolean lost = random.nextDouble() * MILLION < fault.get().amount();
        if (lost) {
          touch(now);
        }
        yield lost ? List.of() : List.of(message);
      }
      case REPEAT -> {
        touch(now);
        yield Collections.nCopies((int) fault.get().amount() + 1, message);
      }
      case CORRUPT -> {
        touch(now);
        byte[] bytes = corrupted(message);
        yield decodes(type, bytes) ? List.of(ByteBuffer.wrap(bytes)) : List.of();
      }
      default -> List.of(message);
    };
  }

  /** Alters bytes after the header, which states the encoding. */
  private byte[] corrupted(ByteBuffer message) {
    byte[] bytes = new byte[message.remaining()];
    message.duplicate().get(bytes);
    int length = bytes.length - CDR_HEADER;
    for (int i = 0; length > 0 && i < 1 + length / BYTES_FOR_ONE; i++) {
      bytes[CDR_HEADER + random.nextInt(length)] ^= (byte) (1 + random.nextInt(255));
    }
    return bytes;
  }

  /** Returns whether bytes are a valid message; DDS delivers no other ones. */
  private static boolean decodes(MessageType type, byte[] bytes) {
    try {
      return Arrays.equals(CdrCodec.encode(CdrCodec.decode(type, bytes)), bytes);
    } catch (IllegalArgumentException e) {
      return false;
    }
  }

  /** Returns the time stamp of a message, in ns. */
  public long stamp(long now) {
    long shown = clock(now);
    if (shown != now) {
      touch(now);
    }
    return shown;
  }

  /** Returns the time on the clock, in ns. */
  public long clock(long now) {
    return fault.map(it -> it.clock(now)).orElse(now);
  }

  private boolean concerns(String topic, long now) {
    return fault.filter(it -> it.target().equals(topic) && it.isActive(now)).isPresent();
  }

  private void touch(long now) {
    affected++;
    first = Math.min(first, now);
  }

  /** Returns the number of messages that were altered or lost. */
  public long affected() {
    return affected;
  }

  /** Returns the time of the first of them, in ns; {@link RunLog#NEVER} if there is none. */
  public long first() {
    return first;
  }
}
