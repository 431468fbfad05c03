package dev.eventchain.catalogue.network;

import dev.eventchain.catalogue.signal.CatalogueRules;
import dev.eventchain.diagnostics.Diagnostic;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Finds signals of a message that share bits. Signals with other numbers of the same multiplexer
 * are never in a message at once, and may.
 */
public final class SharedBits {

  /** The first signal at each bit, of those that are in a message under the same conditions. */
  private static final class Group {

    private final Map<NetworkSignal, List<SendingCondition.Range>> conditions;
    private final Map<Integer, NetworkSignal> owners = new HashMap<>();

    Group(Map<NetworkSignal, List<SendingCondition.Range>> conditions) {
      this.conditions = conditions;
    }

    /** Returns whether signals of this and another group can be in one message. */
    boolean meets(Group other) {
      return conditions.entrySet().stream()
          .allMatch(
              each ->
                  !other.conditions.containsKey(each.getKey())
                      || areJoint(each.getValue(), other.conditions.get(each.getKey())));
    }

    /** Returns the only multiplexer on which it depends, if that has one number for it. */
    Optional<NetworkSignal> numbered() {
      return conditions.entrySet().stream()
          .filter(each -> conditions.size() == 1 && each.getValue().size() == 1)
          .filter(each -> each.getValue().get(0).isOneNumber())
          .map(Map.Entry::getKey)
          .findFirst();
    }

    private static boolean areJoint(
        List<SendingCondition.Range> ranges, List<SendingCondition.Range> others) {
      return ranges.stream()
          .anyMatch(
              one ->
                  others.stream()
                      .anyMatch(
                          other ->
                              one.from().compareTo(other.to()) <= 0
                                  && other.from().compareTo(one.to()) <= 0));
    }

    Optional<NetworkSignal> owner(List<Integer> bits) {
      return bits.stream().filter(owners::containsKey).map(owners::get).findFirst();
    }

    void add(NetworkSignal signal, List<Integer> bits) {
      bits.forEach(bit -> owners.putIfAbsent(bit, signal));
    }
  }

  private final NetworkMessage message;
  private final Map<Map<NetworkSignal, List<SendingCondition.Range>>, Group> groups =
      new LinkedHashMap<>();
  private final Map<Group, List<Group>> meeting = new LinkedHashMap<>();

  private SharedBits(NetworkMessage message) {
    this.message = message;
  }

  /** Reports each signal that shares bits with one before it. */
  public static void check(NetworkMessage message, Consumer<Diagnostic> findings) {
    SharedBits overlaps = new SharedBits(message);
    message.signals().values().forEach(overlaps::group);
    overlaps.findMeeting();
    for (NetworkSignal signal : message.signals().values()) {
      overlaps.place(signal).ifPresent(findings);
    }
  }

  private Group group(NetworkSignal signal) {
    return groups.computeIfAbsent(message.conditions(signal), Group::new);
  }

  /** Finds what may meet; of the many groups with one number each of a multiplexer, none do. */
  private void findMeeting() {
    Map<Optional<NetworkSignal>, List<Group>> byNumber = new LinkedHashMap<>();
    for (Group each : groups.values()) {
      byNumber.computeIfAbsent(each.numbered(), key -> new ArrayList<>()).add(each);
    }
    for (Group one : groups.values()) {
      Optional<NetworkSignal> numbered = one.numbered();
      List<Group> others = new ArrayList<>(List.of(one));
      byNumber.forEach(
          (multiplexer, some) -> {
            if (numbered.isEmpty() || !multiplexer.equals(numbered)) {
              some.stream().filter(other -> other != one && one.meets(other)).forEach(others::add);
            }
          });
      meeting.put(one, others);
    }
  }

  private Optional<Diagnostic> place(NetworkSignal signal) {
    Group own = group(signal);
    List<Integer> bits = signal.layout().bits();
    Optional<NetworkSignal> earlier =
        meeting.get(own).stream().flatMap(each -> each.owner(bits).stream()).findFirst();
    own.add(signal, bits);
    return earlier.map(
        other ->
            Diagnostic.of(
                    CatalogueRules.OVERLAP,
                    "'%s.%s' shares bits with '%s'."
                        .formatted(message.name(), signal.name(), other.name()),
                    signal.place())
                .withHint("One of them has another start, length, byte order or multiplexer."));
  }
}
