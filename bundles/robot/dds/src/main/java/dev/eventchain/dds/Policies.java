package dev.eventchain.dds;

import com.sun.jna.Pointer;
import dev.eventchain.messages.QosSettings;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Optional;
import java.util.function.ToIntFunction;

/**
 * Conversion of QoS settings to those of the library. Policies left to the middleware are chosen as
 * rmw_cyclonedds does; "best available" is the strongest policy for a writer and the weakest for a
 * reader.
 */
final class Policies {

  /** Longest time that a write waits for acknowledgements of readers. */
  static final Duration MAXIMAL_BLOCKING_TIME = Duration.ofMillis(100);

  private static final int XCDR1 = 0;
  private static final int UNLIMITED = -1;
  private static final int MANUAL_BY_TOPIC = 2;

  private Policies() {}

  /** Calls an action with the QoS of a writer or a reader. */
  static int with(
      Cyclone cyclone,
      QosSettings settings,
      Side side,
      String userData,
      ToIntFunction<Pointer> use) {
    return with(
        cyclone,
        userData,
        qos -> {
          int reliable = isReliable(settings, side) ? 1 : 0;
          cyclone.qsetReliability(qos, reliable, MAXIMAL_BLOCKING_TIME.toNanos());
          setHistory(cyclone, qos, settings, side);
          cyclone.qsetDeadline(qos, nanos(settings.deadline()));
          int liveliness = isManual(settings, side) ? MANUAL_BY_TOPIC : 0;
          cyclone.qsetLiveliness(qos, liveliness, nanos(settings.lease()));
          cyclone.qsetDataRepresentation(qos, 1, new short[] {XCDR1});
          if (side == Side.WRITER) {
            cyclone.qsetWriterDataLifecycle(qos, false);
          }
          return use.applyAsInt(qos);
        });
  }

  private static void setHistory(Cyclone cyclone, Pointer qos, QosSettings settings, Side side) {
    boolean all = settings.history() == QosSettings.History.KEEP_ALL;
    int history = all ? 1 : 0;
    int depth = all ? UNLIMITED : Math.max(1, settings.depth());
    cyclone.qsetHistory(qos, history, depth);
    boolean kept = isKept(settings, side);
    cyclone.qsetDurability(qos, kept ? 1 : 0);
    if (kept) {
      cyclone.qsetDurabilityService(qos, 0, history, depth, UNLIMITED, UNLIMITED, UNLIMITED);
    }
  }

  private static boolean isReliable(QosSettings settings, Side side) {
    return switch (settings.reliability()) {
      case RELIABLE, SYSTEM_DEFAULT -> true;
      case BEST_EFFORT -> false;
      case BEST_AVAILABLE -> side == Side.WRITER;
    };
  }

  private static boolean isKept(QosSettings settings, Side side) {
    return switch (settings.durability()) {
      case TRANSIENT_LOCAL -> true;
      case VOLATILE, SYSTEM_DEFAULT -> false;
      case BEST_AVAILABLE -> side == Side.WRITER;
    };
  }

  private static boolean isManual(QosSettings settings, Side side) {
    return switch (settings.liveliness()) {
      case MANUAL_BY_TOPIC -> true;
      case AUTOMATIC -> false;
      case BEST_AVAILABLE -> side == Side.WRITER;
    };
  }

  /** Calls an action with a QoS that has only user data. */
  static int with(Cyclone cyclone, String userData, ToIntFunction<Pointer> use) {
    Pointer qos = cyclone.createQos();
    try {
      byte[] data = userData.getBytes(StandardCharsets.UTF_8);
      cyclone.qsetUserdata(qos, data, data.length);
      return use.applyAsInt(qos);
    } finally {
      cyclone.deleteQos(qos);
    }
  }

  private static long nanos(Optional<Duration> time) {
    return time.map(Duration::toNanos).orElse(Long.MAX_VALUE);
  }
}
