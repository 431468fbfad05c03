package dev.eventchain.catalogue.network;

import dev.eventchain.catalogue.signal.CatalogueRules;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** A network: its nodes and messages, in the order of the file. */
public final class Network {

  private final Set<String> nodes = new LinkedHashSet<>();
  private final Map<Long, NetworkMessage> messages = new LinkedHashMap<>();
  private int usualCycle;

  public Set<String> nodes() {
    return nodes;
  }

  /** Returns the messages that are sent. */
  public List<NetworkMessage> messages() {
    List<NetworkMessage> sent = new ArrayList<>(messages.values());
    sent.removeIf(NetworkMessage::isNeverSent);
    return sent;
  }

  /** Returns a finding if no node has a name. */
  public Optional<Diagnostic> withoutNode(String name, SourceLocation place) {
    return nodes.contains(name)
        ? Optional.empty()
        : Optional.of(
            Diagnostic.of(CatalogueRules.NODE, "The network has no node '" + name + "'.", place)
                .withHint(NearestName.hint(name, nodes)));
  }

  public Optional<NetworkMessage> find(long number) {
    return Optional.ofNullable(messages.get(number));
  }

  /** Adds a message; returns false if there is one with its identifier. */
  public boolean add(NetworkMessage message) {
    return messages.putIfAbsent(message.number(), message) == null;
  }

  /** Returns the time between two of a message, in ms; 0 if it is not sent regularly. */
  public int cycle(NetworkMessage message) {
    return message.cycle().orElse(usualCycle);
  }

  /** Sets the time of messages that state none. */
  public void usualCycle(int milliseconds) {
    usualCycle = milliseconds;
  }
}
