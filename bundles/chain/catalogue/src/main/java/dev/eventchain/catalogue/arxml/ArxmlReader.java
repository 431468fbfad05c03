package dev.eventchain.catalogue.arxml;

import dev.eventchain.catalogue.arxml.ArxmlLimits.NoNumberException;
import dev.eventchain.catalogue.network.Network;
import dev.eventchain.catalogue.network.NetworkMessage;
import dev.eventchain.catalogue.signal.CatalogueRules;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;

/** Makes the messages of a network of the frames of all CAN clusters. */
final class ArxmlReader {

  private static final long LARGEST_IDENTIFIER = 0x7FFF_FFFFL;

  private final ArxmlTree tree;
  private final Consumer<Diagnostic> findings;
  private final ArxmlUnread unread = new ArxmlUnread();
  private final Network network = new Network();
  private final ArxmlPdus pdus;
  private final Map<String, Integer> buses = new LinkedHashMap<>();

  /** A frame with the channels on which it is, and what its first triggering says. */
  private record Sent(ArxmlElement frame, ArxmlElement triggering, Set<ArxmlElement> channels) {}

  /** The channels of a message, and its parts: a PDU may be in containers of several channels. */
  private record Sending(Set<ArxmlElement> channels, Set<ArxmlElement> parts) {

    static Sending nowhere() {
      return new Sending(new LinkedHashSet<>(), new LinkedHashSet<>());
    }
  }

  ArxmlReader(ArxmlTree tree, Consumer<Diagnostic> findings) {
    this.tree = tree;
    this.findings = findings;
    this.pdus = new ArxmlPdus(tree, unread, this::find);
  }

  Network read() {
    tree.all("ECU-INSTANCE").forEach(ecu -> network.nodes().add(ecu.name()));
    List<ArxmlElement> channels = channels();
    channels.forEach(channel -> buses.putIfAbsent(channel.path(), buses.size() + 1));
    ArxmlSenders senders = new ArxmlSenders(tree, channels);
    Map<NetworkMessage, Sending> all = new LinkedHashMap<>();
    for (Sent sent : frames(channels).values()) {
      for (ArxmlPdus.Content content : contents(sent)) {
        Sending sending = all.computeIfAbsent(content.message(), key -> Sending.nowhere());
        sending.channels().addAll(sent.channels());
        sending.parts().addAll(content.parts());
      }
    }
    all.forEach((message, it) -> message.senders().addAll(senders.of(it.channels(), it.parts())));
    pdus.noteOthers();
    tree.otherVariants()
        .forEach(it -> unread.note(ArxmlUnread.Kind.OTHER_VARIANT, it.path(), it.location()));
    unread.report(findings);
    return network;
  }

  private List<ArxmlElement> channels() {
    List<ArxmlElement> channels = new ArrayList<>();
    for (ArxmlElement cluster : tree.all("CAN-CLUSTER")) {
      List<ArxmlElement> variants = cluster.all("CAN-CLUSTER-VARIANTS", "CAN-CLUSTER-CONDITIONAL");
      if (variants.size() > 1) {
        unread.note(ArxmlUnread.Kind.VARIANT, cluster.name(), cluster.location());
      }
      for (ArxmlElement variant : variants) {
        channels.addAll(variant.all("PHYSICAL-CHANNELS", "CAN-PHYSICAL-CHANNEL"));
      }
    }
    return channels;
  }

  /** Returns the frames by their paths: one that a gateway passes on is on several channels. */
  private Map<String, Sent> frames(List<ArxmlElement> channels) {
    Map<String, Sent> frames = new LinkedHashMap<>();
    for (ArxmlElement channel : channels) {
      for (ArxmlElement triggering : channel.all("FRAME-TRIGGERINGS", "CAN-FRAME-TRIGGERING")) {
        Optional<ArxmlElement> frame = tree.follow(triggering, Set.of("CAN-FRAME"), "FRAME-REF");
        if (frame.isEmpty()) {
          continue;
        }
        unread.noteVariants(triggering, frame.get().name());
        Sent sent =
            frames.computeIfAbsent(
                frame.get().path(),
                key -> new Sent(frame.get(), triggering, new LinkedHashSet<>()));
        sent.channels().add(channel);
      }
    }
    return frames;
  }

  /** Returns the message of a frame, and those of the PDUs that it contains. */
  private List<ArxmlPdus.Content> contents(Sent sent) {
    try {
      ArxmlElement channel = sent.channels().iterator().next();
      NetworkMessage message =
          new NetworkMessage(
              number(sent, channel),
              sent.frame().name(),
              ArxmlPdus.size(sent.frame(), "FRAME-LENGTH"));
      Optional<String> problem = message.identifierProblem();
      if (problem.isEmpty() && !network.add(message)) {
        problem =
            Optional.of(
                "There is another message with the identifier " + message.identifier() + ".");
      }
      if (problem.isPresent()) {
        find(problem.get(), sent.triggering().location());
        return List.of();
      }
      message.comment(sent.frame().about());
      List<ArxmlPdus.Content> contents = pdus.of(sent.frame(), message);
      contents.stream().skip(1).forEach(it -> network.add(it.message()));
      return contents;
    } catch (NoNumberException e) {
      find(e.getMessage(), e.place());
      return List.of();
    }
  }

  private long number(Sent sent, ArxmlElement channel) throws NoNumberException {
    Optional<ArxmlElement> identifier = sent.triggering().first("IDENTIFIER");
    if (identifier.isEmpty()) {
      return pdus.unnumbered();
    }
    boolean extended =
        sent.triggering().text("CAN-ADDRESSING-MODE").filter("EXTENDED"::equals).isPresent();
    return ((long) buses.get(channel.path()) << 32)
        + (extended ? NetworkMessage.EXTENDED : 0)
        + ArxmlLimits.whole(identifier.get(), LARGEST_IDENTIFIER);
  }

  private void find(String message, SourceLocation place) {
    findings.accept(Diagnostic.of(CatalogueRules.ENTRY, message, place));
  }
}
