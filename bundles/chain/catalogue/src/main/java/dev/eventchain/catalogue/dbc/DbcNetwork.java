package dev.eventchain.catalogue.dbc;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** A network: its nodes and messages, in the order of the file. */
final class DbcNetwork {

  private final Set<String> nodes = new LinkedHashSet<>();
  private final Map<Long, DbcMessage> messages = new LinkedHashMap<>();
  private int usualCycle;

  Set<String> nodes() {
    return nodes;
  }

  /** Returns the messages that are sent. */
  List<DbcMessage> messages() {
    List<DbcMessage> sent = new ArrayList<>(messages.values());
    sent.removeIf(DbcMessage::isNeverSent);
    return sent;
  }

  Optional<DbcMessage> find(long number) {
    return Optional.ofNullable(messages.get(number));
  }

  /** Adds a message; returns false if there is one with its identifier. */
  boolean add(DbcMessage message) {
    return messages.putIfAbsent(message.number(), message) == null;
  }

  /** Returns the time between two of a message, in ms; 0 if it is not sent regularly. */
  int cycle(DbcMessage message) {
    return message.cycle().orElse(usualCycle);
  }

  /** Sets the time of messages that state none. */
  void usualCycle(int milliseconds) {
    usualCycle = milliseconds;
  }
}
