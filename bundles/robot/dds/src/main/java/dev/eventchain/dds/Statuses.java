package dev.eventchain.dds;

import com.sun.jna.Memory;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Reads the statuses of an endpoint, which resets their counts. */
final class Statuses {

  private static final long SIZE = 32;
  private static final int CHANGE = 4;
  private static final int LAST_POLICY = 8;
  private static final int ALIVE_CHANGE = 8;
  private static final int NOT_ALIVE_CHANGE = 12;

  /** {@code dds_qos_policy_id_t}: the policies by which endpoints may be incompatible. */
  private static final Map<Integer, String> POLICIES =
      Map.of(
          2, "durability",
          3, "presentation",
          4, "deadline",
          5, "latency budget",
          6, "ownership",
          8, "liveliness",
          11, "reliability",
          12, "destination order",
          23, "data representation",
          24, "type consistency");

  private final Cyclone cyclone;
  private final int endpoint;
  private final List<DdsEvent> events = new ArrayList<>();

  /** Native memory is not zeroed on allocation. */
  private final Memory status = new Memory(SIZE);

  private Statuses(Cyclone cyclone, int endpoint) {
    this.cyclone = cyclone;
    this.endpoint = endpoint;
    status.clear();
  }

  static List<DdsEvent> ofWriter(Cyclone cyclone, int writer) {
    Statuses found = new Statuses(cyclone, writer);
    found.incompatible(cyclone.getOfferedIncompatibleQosStatus(writer, found.status));
    found.deadline(cyclone.getOfferedDeadlineMissedStatus(writer, found.status));
    found.check(cyclone.getLivelinessLostStatus(writer, found.status));
    found.add(DdsEvent.Kind.LIVELINESS_LOST, CHANGE, "");
    return List.copyOf(found.events);
  }

  static List<DdsEvent> ofReader(Cyclone cyclone, int reader) {
    Statuses found = new Statuses(cyclone, reader);
    found.incompatible(cyclone.getRequestedIncompatibleQosStatus(reader, found.status));
    found.deadline(cyclone.getRequestedDeadlineMissedStatus(reader, found.status));
    found.check(cyclone.getLivelinessChangedStatus(reader, found.status));
    found.add(DdsEvent.Kind.LIVELINESS_GAINED, ALIVE_CHANGE, "");
    found.add(DdsEvent.Kind.LIVELINESS_LOST, NOT_ALIVE_CHANGE, "");
    found.check(cyclone.getSampleLostStatus(reader, found.status));
    found.add(DdsEvent.Kind.SAMPLE_LOST, CHANGE, "");
    return List.copyOf(found.events);
  }

  private void incompatible(int result) {
    check(result);
    int policy = status.getInt(LAST_POLICY);
    add(DdsEvent.Kind.INCOMPATIBLE_QOS, CHANGE, POLICIES.getOrDefault(policy, "policy " + policy));
  }

  private void deadline(int result) {
    check(result);
    add(DdsEvent.Kind.DEADLINE_MISSED, CHANGE, "");
  }

  private void check(int result) {
    Codes.check(cyclone, result, "read the status of endpoint " + endpoint);
  }

  private void add(DdsEvent.Kind kind, int offset, String policy) {
    int count = status.getInt(offset);
    if (count > 0) {
      events.add(new DdsEvent(kind, count, policy));
    }
  }
}
