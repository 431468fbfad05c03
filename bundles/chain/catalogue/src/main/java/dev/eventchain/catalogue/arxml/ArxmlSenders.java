package dev.eventchain.catalogue.arxml;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Senders of messages: ECUs with an outgoing port for a frame, or else for its PDUs, or else for
 * its signals, or else with an outgoing group of its PDUs. An ECU that also receives a message
 * passes it on from bus to bus, and is not who sends it.
 */
final class ArxmlSenders {

  /** ECUs that send something, and those that receive it. */
  private static final class Ends {
    private final Set<String> out = new LinkedHashSet<>();
    private final Set<String> in = new LinkedHashSet<>();

    void add(String ecu, String direction) {
      if (direction.equals("OUT")) {
        out.add(ecu);
      } else if (direction.equals("IN")) {
        in.add(ecu);
      }
    }
  }

  /** A way to say who sends: the elements of channels that name ports, and their tags. */
  private record Way(
      String triggerings, String triggering, String about, String ports, String port) {}

  private static final List<Way> WAYS =
      List.of(
          new Way(
              "FRAME-TRIGGERINGS",
              "CAN-FRAME-TRIGGERING",
              "FRAME-REF",
              "FRAME-PORT-REFS",
              "FRAME-PORT-REF"),
          new Way(
              "PDU-TRIGGERINGS",
              "PDU-TRIGGERING",
              "I-PDU-REF",
              "I-PDU-PORT-REFS",
              "I-PDU-PORT-REF"),
          new Way(
              "I-SIGNAL-TRIGGERINGS",
              "I-SIGNAL-TRIGGERING",
              "I-SIGNAL-REF",
              "I-SIGNAL-PORT-REFS",
              "I-SIGNAL-PORT-REF"));

  private static final Set<String> GROUP = Set.of("I-SIGNAL-I-PDU-GROUP");

  private final ArxmlTree tree;

  /** Ends by ways, and paths of channels and of what they are about. */
  private final List<Map<String, Ends>> ends = new ArrayList<>();

  private final Map<String, Ends> groups = new HashMap<>();

  ArxmlSenders(ArxmlTree tree, List<ArxmlElement> channels) {
    this.tree = tree;
    for (Way way : WAYS) {
      Map<String, Ends> byPath = new HashMap<>();
      channels.forEach(channel -> ports(channel, way, byPath));
      ends.add(byPath);
    }
    for (ArxmlElement ecu : tree.all("ECU-INSTANCE")) {
      for (ArxmlElement group :
          ecu.all("ASSOCIATED-COM-I-PDU-GROUP-REFS", "ASSOCIATED-COM-I-PDU-GROUP-REF")) {
        tree.follow(group, GROUP).ifPresent(it -> group(it, ecu.name()));
      }
    }
  }

  private void ports(ArxmlElement channel, Way way, Map<String, Ends> byPath) {
    for (ArxmlElement triggering : channel.all(way.triggerings(), way.triggering())) {
      List<ArxmlElement> ports = triggering.all(way.ports(), way.port());
      Optional<ArxmlElement> about =
          ports.isEmpty() ? Optional.empty() : tree.follow(triggering, Set.of(), way.about());
      for (ArxmlElement reference : about.isEmpty() ? List.<ArxmlElement>of() : ports) {
        Optional<ArxmlElement> port = tree.follow(reference, Set.of());
        Optional<ArxmlElement> ecu = port.flatMap(it -> tree.around(it, "ECU-INSTANCE"));
        if (ecu.isPresent()) {
          byPath
              .computeIfAbsent(key(channel, about.get()), key -> new Ends())
              .add(ecu.get().name(), port.get().text("COMMUNICATION-DIRECTION").orElse(""));
        }
      }
    }
  }

  private static String key(ArxmlElement channel, ArxmlElement about) {
    return channel.path() + " " + about.path();
  }

  /** Adds what a group and those in it hold, each once. */
  private void group(ArxmlElement first, String ecu) {
    Set<String> seen = new HashSet<>();
    Deque<ArxmlElement> open = new ArrayDeque<>(List.of(first));
    while (!open.isEmpty()) {
      ArxmlElement group = open.pop();
      if (seen.add(group.path())) {
        pdus(group, ecu);
        group
            .all("CONTAINED-I-SIGNAL-I-PDU-GROUP-REFS", "CONTAINED-I-SIGNAL-I-PDU-GROUP-REF")
            .stream()
            .flatMap(it -> tree.follow(it, GROUP).stream())
            .forEach(open::push);
      }
    }
  }

  private void pdus(ArxmlElement group, String ecu) {
    String direction = group.text("COMMUNICATION-DIRECTION").orElse("");
    for (ArxmlElement reference :
        group.all("I-SIGNAL-I-PDUS", "I-SIGNAL-I-PDU-REF-CONDITIONAL", "I-SIGNAL-I-PDU-REF")) {
      tree.follow(reference, Set.of())
          .ifPresent(
              pdu -> groups.computeIfAbsent(pdu.path(), key -> new Ends()).add(ecu, direction));
    }
  }

  /**
   * Returns the names of the ECUs that send a message.
   *
   * @param channels on which it is
   * @param parts the frame, PDUs and signals of the message
   */
  Set<String> of(Set<ArxmlElement> channels, Set<ArxmlElement> parts) {
    for (Map<String, Ends> way : ends) {
      List<Ends> found = new ArrayList<>();
      for (ArxmlElement channel : channels) {
        parts.forEach(
            part -> Optional.ofNullable(way.get(key(channel, part))).ifPresent(found::add));
      }
      if (!found.isEmpty()) {
        return onlySending(found);
      }
    }
    return onlySending(
        parts.stream().map(it -> groups.get(it.path())).filter(it -> it != null).toList());
  }

  private static Set<String> onlySending(List<Ends> all) {
    Set<String> senders = new LinkedHashSet<>();
    all.forEach(each -> senders.addAll(each.out));
    all.forEach(each -> senders.removeAll(each.in));
    return senders;
  }
}
