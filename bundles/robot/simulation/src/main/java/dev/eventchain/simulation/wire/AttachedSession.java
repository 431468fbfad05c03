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
 * Nodes that others run, in real time: the world publishes what is due, hears what the nodes
 * publish, and sees nothing of what happens inside them. The clock shows the time of the wall, so
 * that it never goes back, and nodes that do not follow it have the same time.
 */
final class AttachedSession implements NodeSession {

  private static final long PAUSE = TimeUnit.MILLISECONDS.toNanos(20);

  /** A writer may be known here a moment before it is known there that it writes for us. */
  private static final long LEAD = TimeUnit.MILLISECONDS.toNanos(500);

  /** Timers of nodes that follow the clock are as fine as its steps. */
  private static final long CLOCK_STEP = TimeUnit.MILLISECONDS.toNanos(10);

  /** Who said something so late in a scenario lived to its end. */
  private static final long FRESH = TimeUnit.SECONDS.toNanos(1);

  /** After this, what a killed process had is gone: 10 s with Cyclone DDS, 20 s with Fast DDS. */
  private static final long LEASE = TimeUnit.SECONDS.toNanos(22);

  /** One that matches no more may still be known for a moment. */
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
   * In a domain.
   *
   * @param chain the topics that the nodes have to have
   * @param patience how long nodes are waited for
   */
  AttachedSession(
      DdsParticipant participant, ChainTopics chain, DdsAttachment where, Duration patience) {
    this.participant = participant;
    this.chain = chain;
    this.where = where;
    this.patience = patience;
  }

  /** In ns since 1970. */
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
    world.arrivals(); // what belongs to the scenario before
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
      // One that comes after its time is followed from now on, as a vehicle would.
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

  /** Lets the clock continue until a time of the scenario. */
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
   * Nobody has vanished.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException {@code simulation.node.lost}
   */
  private void requireAll() {
    List<Integer> found = world.matches();
    for (int i = 0; i < found.size(); i++) {
      looks = found.get(i) < matches.get(i) ? LOOKS : looks;
    }
    matches = found;
    if (looks > 0) { // who it was costs more to find out
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
   * A process that was killed is missed only when its lease ends, and a scenario may end before:
   * whoever writes for the world and was not heard lately is waited for.
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
