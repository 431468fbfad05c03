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
 * What a fault does to the world's own messages on their way to the nodes, and to its clock. What
 * nodes publish is changed where they run.
 */
public final class WorldFault {

  private static final int CDR_HEADER = 4;

  /** So many bytes of a message for each that is changed. */
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

  /** Whether a sensor says nothing at this time, in ns. */
  public boolean silences(String topic, long now) {
    boolean silent = concerns(topic, now) && fault.get().kind() == FaultKind.DEAD_SENSOR;
    if (silent) {
      touch(now);
    }
    return silent;
  }

  /** What comes of a message that arrives at this time: nothing, or messages one after another. */
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

  /** With other bytes after the header, which says how to read them. */
  private byte[] corrupted(ByteBuffer message) {
    byte[] bytes = new byte[message.remaining()];
    message.duplicate().get(bytes);
    int length = bytes.length - CDR_HEADER;
    for (int i = 0; length > 0 && i < 1 + length / BYTES_FOR_ONE; i++) {
      bytes[CDR_HEADER + random.nextInt(length)] ^= (byte) (1 + random.nextInt(255));
    }
    return bytes;
  }

  /** Whether bytes are a message, in the only form that it has: DDS hands on nothing else. */
  private static boolean decodes(MessageType type, byte[] bytes) {
    try {
      return Arrays.equals(CdrCodec.encode(CdrCodec.decode(type, bytes)), bytes);
    } catch (IllegalArgumentException e) {
      return false;
    }
  }

  /** The time that the stamp of a message shows, in ns. */
  public long stamp(long now) {
    long shown = clock(now);
    if (shown != now) {
      touch(now);
    }
    return shown;
  }

  /** The time that the clock shows, in ns. */
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

  /** How many of its messages were changed or did not come. */
  public long affected() {
    return affected;
  }

  /** When that was first, in ns; {@link RunLog#NEVER} if it never was. */
  public long first() {
    return first;
  }
}
