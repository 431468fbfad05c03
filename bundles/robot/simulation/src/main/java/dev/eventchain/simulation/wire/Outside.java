package dev.eventchain.simulation.wire;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.dds.DdsParticipant.Peer;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.QosSettings.Incompatibility;
import java.util.ArrayList;
import java.util.List;
import java.util.NavigableSet;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Remote writers and readers on the topics of the world in a domain, and their match with the
 * chain.
 *
 * @param peers the peers on topics of the world
 * @param nodes the names of all discovered nodes, on any topic
 * @param isEmpty true if no peer was found on any topic
 * @param graph the writers and readers of the peers by owner, and the world
 */
record Outside(List<Peer> peers, NavigableSet<String> nodes, boolean isEmpty, WireGraph graph) {

  private static final String CLOCK = "/clock";

  /**
   * Creates the view of the discovered peers.
   *
   * @param found all remote writers and readers in the domain
   * @param configuration names the topics of the world
   */
  static Outside of(List<Peer> found, JsonNode configuration) {
    Set<String> topics =
        Stream.of("world_publishes", "world_subscribes")
            .flatMap(name -> configuration.path(name).valueStream())
            .map(topic -> topic.path("topic").asText())
            .collect(Collectors.toSet());
    List<Peer> peers = found.stream().filter(peer -> topics.contains(peer.topic())).toList();
    List<WireEnd> writers = new ArrayList<>();
    List<WireEnd> readers = new ArrayList<>();
    for (int owner = 0; owner < peers.size(); owner++) {
      Peer peer = peers.get(owner);
      WireEnd end = new WireEnd(owner, 0, peer.topic(), peer.type(), peer.qos(), "");
      (peer.writes() ? writers : readers).add(end);
    }
    NavigableSet<String> nodes = new TreeSet<>();
    found.stream().map(Peer::node).filter(node -> !node.isEmpty()).forEach(nodes::add);
    return new Outside(
        peers, nodes, found.isEmpty(), WireGraph.around(writers, readers, configuration));
  }

  /**
   * Returns what prevents the scenario, in words.
   *
   * @param chain each topic that the vehicle consumes from it needs a writer, and each topic of the
   *     world except the clock a reader, which its own nodes must not fail to be; the world must be
   *     the only writer of its topics that the chain does not write
   */
  List<String> missing(ChainTopics chain) {
    List<String> missing = new ArrayList<>();
    for (WireEnd writer : graph.writersOf(WireEnd.WORLD)) {
      if (!writer.topic().equals(CLOCK)) {
        missing.addAll(
            graph.sinks(writer).isEmpty() ? List.of(why(writer, false)) : deaf(writer, chain));
      }
    }
    for (WireEnd reader : graph.readersOf(WireEnd.WORLD)) {
      if (chain.taken().contains(reader.topic()) && graph.sources(reader).isEmpty()) {
        missing.add(why(reader, true));
      }
    }
    missing.addAll(otherDefinitions(chain.catalog()));
    missing.addAll(rivals(chain.written()));
    return missing;
  }

  /** Returns the nodes of the chain that read a topic of the world in vain, while others get it. */
  private List<String> deaf(WireEnd world, ChainTopics chain) {
    return graph.readers().stream()
        .filter(reader -> reader.owner() != WireEnd.WORLD && !world.feeds(reader))
        .map(reader -> peers.get(reader.owner()))
        .filter(peer -> peer.topic().equals(world.topic()))
        .filter(peer -> chain.nodes().contains(peer.node().replaceFirst(".*/", "")))
        .map(peer -> world.topic() + " is read" + by(peer) + misfit(world, peer))
        .distinct()
        .toList();
  }

  /** Returns writers that compete with the world, such as another simulator. */
  private List<String> rivals(Set<String> written) {
    return peers.stream()
        .filter(peer -> peer.writes() && !written.contains(peer.topic()))
        .filter(
            peer ->
                graph.writersOf(WireEnd.WORLD).stream()
                    .anyMatch(end -> end.topic().equals(peer.topic())))
        .map(peer -> peer.topic() + " is written" + by(peer) + ", too")
        .distinct()
        .toList();
  }

  /** Returns why a writer or reader of the world has no match. */
  private String why(WireEnd world, boolean writes) {
    String is = writes ? "written" : "read";
    List<String> others =
        peers.stream()
            .filter(peer -> peer.topic().equals(world.topic()) && peer.writes() == writes)
            .map(peer -> by(peer) + misfit(world, peer))
            .distinct()
            .toList();
    return others.isEmpty()
        ? "nothing " + (writes ? "writes " : "reads ") + world.topic() + " (" + world.type() + ")"
        : world.topic() + " is " + is + String.join(" and", others);
  }

  private static String misfit(WireEnd world, Peer peer) {
    if (!peer.type().equals(world.type())) {
      return " as " + peer.type() + ", and here it is " + world.type();
    }
    QosSettings offered = peer.writes() ? peer.qos() : world.qos();
    QosSettings requested = peer.writes() ? world.qos() : peer.qos();
    return " with an incompatible quality of service: "
        + QosSettings.incompatibilities(offered, requested).stream()
            .map(Incompatibility::policy)
            .collect(Collectors.joining(", "));
  }

  /**
   * Returns topics whose types have different definitions; DDS matches types by name, so their
   * samples would be misread.
   */
  private List<String> otherDefinitions(MessageCatalog catalog) {
    return peers.stream()
        .filter(peer -> !peer.typeHash().isEmpty() && isOfTheWorld(peer))
        .filter(
            peer ->
                catalog
                    .find(peer.type())
                    .map(MessageType::hash)
                    .filter(hash -> !hash.equals(peer.typeHash()))
                    .isPresent())
        .map(
            peer ->
                peer.topic()
                    + (peer.writes() ? " is written" : " is read")
                    + by(peer)
                    + " with another definition of "
                    + peer.type()
                    + catalog
                        .otherDistribution(peer.type(), type -> type.hash().equals(peer.typeHash()))
                        .map(other -> ", that of ROS 2 " + other + " ('ros_distro')")
                        .orElse(""))
        .distinct()
        .toList();
  }

  private boolean isOfTheWorld(Peer peer) {
    List<WireEnd> world =
        peer.writes() ? graph.readersOf(WireEnd.WORLD) : graph.writersOf(WireEnd.WORLD);
    return world.stream()
        .anyMatch(end -> end.topic().equals(peer.topic()) && end.type().equals(peer.type()));
  }

  private static String by(Peer peer) {
    return peer.node().isEmpty() ? "" : " by node " + peer.node();
  }

  /**
   * Returns the peers that exchange samples with the world, except those that only read its clock.
   */
  List<Peer> partners() {
    List<Peer> partners = new ArrayList<>();
    for (WireEnd writer : graph.writersOf(WireEnd.WORLD)) {
      graph.readers().stream()
          .filter(writer::feeds)
          .filter(reader -> reader.owner() != WireEnd.WORLD && !writer.topic().equals(CLOCK))
          .forEach(reader -> partners.add(peers.get(reader.owner())));
    }
    for (WireEnd reader : graph.readersOf(WireEnd.WORLD)) {
      graph.sources(reader).stream()
          .filter(writer -> writer.owner() != WireEnd.WORLD)
          .forEach(writer -> partners.add(peers.get(writer.owner())));
    }
    return partners;
  }

  /** Describes vanished peers. */
  static String vanished(List<Peer> gone) {
    return gone.stream()
        .map(
            peer ->
                "the "
                    + (peer.writes() ? "writer" : "reader")
                    + " of "
                    + peer.topic()
                    + (peer.node().isEmpty() ? "" : " (node " + peer.node() + ")"))
        .distinct()
        .collect(Collectors.joining(", "));
  }
}
