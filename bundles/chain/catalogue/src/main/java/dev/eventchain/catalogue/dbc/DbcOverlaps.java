package dev.eventchain.catalogue.dbc;

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
final class DbcOverlaps {

  /** The first signal at each bit, of those that are in a message under the same conditions. */
  private static final class Group {

    private final Map<DbcSignal, List<DbcCondition.Range>> conditions;
    private final Map<Integer, DbcSignal> owners = new HashMap<>();

    Group(Map<DbcSignal, List<DbcCondition.Range>> conditions) {
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
    Optional<DbcSignal> numbered() {
      return conditions.entrySet().stream()
          .filter(each -> conditions.size() == 1 && each.getValue().size() == 1)
          .filter(each -> each.getValue().get(0).isOneNumber())
          .map(Map.Entry::getKey)
          .findFirst();
    }

    private static boolean areJoint(
        List<DbcCondition.Range> ranges, List<DbcCondition.Range> others) {
      return ranges.stream()
          .anyMatch(
              one ->
                  others.stream()
                      .anyMatch(
                          other ->
                              one.from().compareTo(other.to()) <= 0
                                  && other.from().compareTo(one.to()) <= 0));
    }

    Optional<DbcSignal> owner(List<Integer> bits) {
      return bits.stream().filter(owners::containsKey).map(owners::get).findFirst();
    }

    void add(DbcSignal signal, List<Integer> bits) {
      bits.forEach(bit -> owners.putIfAbsent(bit, signal));
    }
  }

  private final DbcMessage message;
  private final Map<Map<DbcSignal, List<DbcCondition.Range>>, Group> groups = new LinkedHashMap<>();
  private final Map<Group, List<Group>> meeting = new LinkedHashMap<>();

  private DbcOverlaps(DbcMessage message) {
    this.message = message;
  }

  /** Reports each signal that shares bits with one before it. */
  static void check(DbcMessage message, Consumer<Diagnostic> findings) {
    DbcOverlaps overlaps = new DbcOverlaps(message);
    message.signals().values().forEach(overlaps::group);
    overlaps.findMeeting();
    for (DbcSignal signal : message.signals().values()) {
      overlaps.place(signal).ifPresent(findings);
    }
  }

  private Group group(DbcSignal signal) {
    return groups.computeIfAbsent(message.conditions(signal), Group::new);
  }

  /** Finds what may meet; of the many groups with one number each of a multiplexer, none do. */
  private void findMeeting() {
    Map<Optional<DbcSignal>, List<Group>> byNumber = new LinkedHashMap<>();
    for (Group each : groups.values()) {
      byNumber.computeIfAbsent(each.numbered(), key -> new ArrayList<>()).add(each);
    }
    for (Group one : groups.values()) {
      Optional<DbcSignal> numbered = one.numbered();
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

  private Optional<Diagnostic> place(DbcSignal signal) {
    Group own = group(signal);
    List<Integer> bits = signal.layout().bits();
    Optional<DbcSignal> earlier =
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
