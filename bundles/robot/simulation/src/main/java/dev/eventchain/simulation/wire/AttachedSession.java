package dev.eventchain.simulation.wire;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.dds.DdsParticipant;
import dev.eventchain.dds.DdsParticipant.Peer;
import dev.eventchain.simulation.host.NodeSession;
import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.node.DdsAttachment;
import dev.eventchain.simulation.wire.AttachedWorld.Arrival;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Collectors;

/**
 * Session with nodes that run elsewhere, in real time: the world publishes due messages and
 * receives those of the nodes, whose activations are not visible. The clock shows wall time, so
 * that it never goes back, and nodes that do not follow it have the same time.
 */
final class AttachedSession implements NodeSession {

  private static final long PAUSE = TimeUnit.MILLISECONDS.toNanos(20);

  /** Time for remote participants to discover writers that are known here already. */
  private static final long LEAD = TimeUnit.MILLISECONDS.toNanos(500);

  /** Step of the clock, the resolution of timers of nodes that follow it. */
  private static final long CLOCK_STEP = TimeUnit.MILLISECONDS.toNanos(10);

  /** Time before the end of a scenario within which a message proves that its writer was alive. */
  private static final long FRESH = TimeUnit.SECONDS.toNanos(1);

  /** Maximum lease after the end of a killed process: 10 s with Cyclone DDS, 20 s with Fast DDS. */
  private static final long LEASE = TimeUnit.SECONDS.toNanos(22);

  /** Number of checks after a lost match, since the peer may remain known for a moment. */
  private static final int LOOKS = 3;

  private final DdsParticipant participant;
  private final ChainTopics chain;
  private final DdsAttachment where;
  private final Duration patience;
  private final List<String> topics = new ArrayList<>();
  private final Map<String, Map<Long, Long>> publications = new LinkedHashMap<>();
  private final Map<Long, Long> heard = new HashMap<>();
  private AttachedWorld world;
  private List<Peer> partners = List.of();
  private List<Integer> matches = List.of();
  private int looks;
  private long start;
  private long now;
  private long shown;
  private long overrun;

  /**
   * Creates a session in a domain.
   *
   * @param chain the topics that the nodes must have
   * @param patience maximum time to wait for nodes
   */
  AttachedSession(
      DdsParticipant participant, ChainTopics chain, DdsAttachment where, Duration patience) {
    this.participant = participant;
    this.chain = chain;
    this.where = where;
    this.patience = patience;
  }

  /** Returns wall time, in ns since 1970. */
  private static long wall() {
    Instant instant = Instant.now();
    return TimeUnit.SECONDS.toNanos(instant.getEpochSecond()) + instant.getNano();
  }

  @Override
  public JsonNode configure(JsonNode configuration) {
    topics.clear();
    configuration
        .path("world_subscribes")
        .forEach(topic -> topics.add(topic.path("topic").asText()));
    Outside outside = meet(configuration);
    partners = outside.partners();
    matches = world.matches();
    looks = LOOKS;
    LockSupport.parkNanos(LEAD);
    world.arrivals(); // samples of the previous scenario
    publications.clear();
    heard.clear();
    now = 0;
    shown = -CLOCK_STEP;
    overrun = 0;
    start = wall();
    ObjectNode ready = JsonNodeFactory.instance.objectNode();
    ready.put("python", "");
    ready.set("warnings", outside.graph().warnings());
    return ready;
  }

  /** Waits until all nodes are connected. */
  private Outside meet(JsonNode configuration) {
    long end = System.nanoTime() + patience.toNanos();
    while (true) {
      Outside outside = Outside.of(participant.peers(), configuration);
      List<String> missing = outside.missing(chain);
      if (missing.isEmpty()) {
        connect(outside.graph());
        missing = world.unconnected(outside.graph());
      }
      if (missing.isEmpty()) {
        return outside;
      }
      if (System.nanoTime() >= end) {
        throw AttachedFailures.unmatched(outside, missing, where.domain(), patience);
      }
      LockSupport.parkNanos(PAUSE);
    }
  }

  private void connect(WireGraph graph) {
    if (world == null || !world.suits(graph)) {
      if (world != null) {
        world.close();
      }
      world = new AttachedWorld(participant, graph, chain.catalog(), AttachedSession::wall);
    }
  }

  @Override
  public long epoch() {
    return start;
  }

  @Override
  public List<Outbound> step(long until, List<Inbound> messages) {
    waitFor(now);
    for (Inbound message : messages) {
      String deaf = world.publish(message.topic(), message.message());
      if (!deaf.isEmpty()) {
        throw AttachedFailures.deaf(deaf, now);
      }
    }
    measureOverrun(now); // publishing may have taken a while
    waitFor(until);
    measureOverrun(until);
    List<Outbound> published = new ArrayList<>();
    for (Arrival each : world.arrivals()) {
      // Late messages are followed from now on, as by a vehicle.
      long time = Math.max(now, Math.min(each.time() - start, until - 1));
      published.add(new Outbound(time, each.reader(), ByteBuffer.wrap(each.sample().bytes())));
      note(each, time);
    }
    published.sort((one, other) -> Long.compare(one.time(), other.time()));
    now = until;
    return published;
  }

  private void note(Arrival arrival, long time) {
    heard.put(arrival.sample().publication(), arrival.time());
    Map<Long, Long> times =
        publications.computeIfAbsent(topics.get(arrival.reader()), it -> new LinkedHashMap<>());
    times.put((long) times.size(), time);
  }

  private void measureOverrun(long due) {
    overrun = Math.max(overrun, wall() - start - due);
  }

  /** Advances the clock until a time of the scenario. */
  private void waitFor(long time) {
    do {
      requireAll();
      long passed = Math.min(wall() - start, time);
      if (passed >= shown + CLOCK_STEP || (passed == time && passed > shown)) {
        shown = passed;
        world.show(start + passed);
      }
      long next = Math.min(time, shown + CLOCK_STEP);
      long left = start + next - wall();
      if (left > 0) {
        LockSupport.parkNanos(left);
      }
    } while (wall() - start < time);
  }

  /**
   * Checks that no node has vanished.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException {@code simulation.node.lost}
   */
  private void requireAll() {
    List<Integer> found = world.matches();
    for (int i = 0; i < found.size(); i++) {
      looks = found.get(i) < matches.get(i) ? LOOKS : looks;
    }
    matches = found;
    if (looks > 0) { // finding the vanished peers is slow
      looks--;
      Set<String> there =
          participant.peers().stream().map(Peer::id).collect(Collectors.toUnmodifiableSet());
      List<Peer> gone = partners.stream().filter(peer -> !there.contains(peer.id())).toList();
      if (!gone.isEmpty()) {
        throw AttachedFailures.vanished(gone, Math.max(0, wall() - start));
      }
    }
  }

  @Override
  public RunLog finish() {
    requireSignsOfLife();
    Map<String, Map<Long, Long>> copy = new LinkedHashMap<>();
    publications.forEach((topic, times) -> copy.put(topic, new LinkedHashMap<>(times)));
    return new RunLog(Map.of(), copy);
  }

  /**
   * Waits for writers to the world without recent messages. A killed process is detected only when
   * its lease ends, which may be after the end of the scenario.
   */
  private void requireSignsOfLife() {
    long since = wall() - FRESH;
    long end = System.nanoTime() + LEASE;
    requireAll();
    while (System.nanoTime() < end && isAnybodySilent(since)) {
      LockSupport.parkNanos(PAUSE);
      world
          .arrivals()
          .forEach(arrival -> heard.put(arrival.sample().publication(), arrival.time()));
      requireAll();
    }
  }

  private boolean isAnybodySilent(long since) {
    Set<String> alive = new HashSet<>();
    Set<String> writing = new HashSet<>();
    for (Peer peer : partners) {
      if (peer.writes()) {
        writing.add(peer.participant());
        if (heard.getOrDefault(peer.handle(), Long.MIN_VALUE) >= since) {
          alive.add(peer.participant());
        }
      }
    }
    return !alive.containsAll(writing);
  }

  @Override
  public long overrun() {
    return overrun;
  }
}
