package dev.eventchain.catalogue.dbc;

import java.math.BigDecimal;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;

/** A message of a network, while its statements are read. */
final class DbcMessage {

  /** The largest identifier that a file can have, in 32 bits. */
  static final long LARGEST_NUMBER = 0xFFFF_FFFFL;

  /** Bit that marks an identifier of 29 bits. */
  private static final long EXTENDED = 0x8000_0000L;

  /** The message of signals that no message has, which is never sent. */
  private static final String WITHOUT_MESSAGE = "VECTOR__INDEPENDENT_SIG_MSG";

  private final long number;
  private final String name;
  private final int size;
  private final Set<String> senders = new LinkedHashSet<>();
  private final Map<String, DbcSignal> signals = new LinkedHashMap<>();
  private String longName = "";
  private String comment = "";
  private OptionalInt cycle = OptionalInt.empty();

  /**
   * Creates a message without signals.
   *
   * @param number its identifier as the file has it
   * @param size in bytes
   */
  DbcMessage(long number, String name, int size) {
    this.number = number;
    this.name = name;
    this.size = size;
  }

  boolean isExtended() {
    return (number & EXTENDED) != 0;
  }

  boolean isNeverSent() {
    return name.equals(WITHOUT_MESSAGE);
  }

  /** Returns the identifier on the bus. */
  long identifier() {
    return number & ~EXTENDED;
  }

  long number() {
    return number;
  }

  String name() {
    return longName.isEmpty() ? name : longName;
  }

  int size() {
    return size;
  }

  /** Returns the nodes that send it. */
  Set<String> senders() {
    return senders;
  }

  /** Returns the signals by the names of their statements. */
  Map<String, DbcSignal> signals() {
    return signals;
  }

  /** Returns when a multiplexed signal is there; empty if it always is. */
  Optional<DbcCondition> condition(DbcSignal signal) {
    if (signal.multiplexed().isEmpty() || signal.condition().isPresent()) {
      return signal.condition();
    }
    List<DbcCondition.Range> number =
        List.of(DbcCondition.Range.of(new BigDecimal(signal.multiplexed())));
    return signals.values().stream()
        .filter(it -> it.isMultiplexer() && it.multiplexed().isEmpty())
        .map(it -> new DbcCondition(it, number))
        .findFirst();
  }

  /**
   * Returns the numbers of all multiplexers on which a signal depends, those of others included.
   */
  Map<DbcSignal, List<DbcCondition.Range>> conditions(DbcSignal signal) {
    Map<DbcSignal, List<DbcCondition.Range>> all = new LinkedHashMap<>();
    Optional<DbcCondition> next = condition(signal);
    while (next.isPresent() && !all.containsKey(next.get().multiplexer())) {
      all.put(next.get().multiplexer(), next.get().ranges());
      next = condition(next.get().multiplexer());
    }
    return all;
  }

  String comment() {
    return comment;
  }

  /** Returns the stated time between two of them in ms, 0 if it is not sent regularly. */
  OptionalInt cycle() {
    return cycle;
  }

  void rename(String full) {
    longName = full;
  }

  void comment(String text) {
    comment = text;
  }

  void cycle(int milliseconds) {
    cycle = OptionalInt.of(milliseconds);
  }
}
