package dev.eventchain.simulation.host;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.simulation.host.NodeSession.Outbound;
import dev.eventchain.simulation.host.RunLog.Activation;
import dev.eventchain.simulation.host.RunLog.SampleId;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Checks that a log is consistent with the driven scenario, since measurements rely on it. Its
 * nodes must be those of the configuration, its times those of the protocol, and its samples those
 * that were published.
 */
public final class RunLogCheck {

  private static final double NANOSECONDS = 1e6;

  private final RunLog log;
  private final JsonNode configuration;
  private final long end;
  private final Set<SampleId> written = new HashSet<>();

  /**
   * Creates a check of one log.
   *
   * @param configuration the configuration of the process
   * @param end end of the driven time, in ns
   */
  public RunLogCheck(RunLog log, JsonNode configuration, long end) {
    this.log = log;
    this.configuration = configuration;
    this.end = end;
  }

  /**
   * Checks a log of simulated time.
   *
   * @param commands all messages received from the nodes
   * @throws IllegalArgumentException with the contradiction
   */
  public void check(List<Outbound> commands) {
    List<String> names = new ArrayList<>();
    for (JsonNode node : configuration.path("nodes")) {
      String name = node.path("name").asText();
      names.add(name);
      long executionTime = Math.round(node.path("execution_time_ms").asDouble() * NANOSECONDS);
      long earliest = 0;
      for (Activation activation : log.nodes().getOrDefault(name, List.of())) {
        check(name, activation, earliest, executionTime);
        earliest = activation.end();
      }
    }
    require(names.equals(List.copyOf(log.nodes().keySet())), "nodes other than those configured");
    checkPublications();
    checkCommands(commands);
  }

  /**
   * Checks a log of real time, in which execution times vary, samples get lost and times are not
   * exact.
   *
   * @throws IllegalArgumentException with the contradiction
   */
  public void checkInRealTime() {
    List<String> names = new ArrayList<>();
    for (JsonNode node : configuration.path("nodes")) {
      String name = node.path("name").asText();
      names.add(name);
      long earliest = 0;
      for (Activation activation : log.nodes().getOrDefault(name, List.of())) {
        boolean inOrder = activation.start() >= earliest && activation.end() >= activation.start();
        require(inOrder && activation.host() >= 0, "an impossible time of " + name);
        activation.reads().forEach(read -> time(read, name));
        activation.writes().forEach(sample -> require(written.add(sample), "a sample twice"));
        earliest = activation.end();
      }
    }
    require(names.equals(List.copyOf(log.nodes().keySet())), "nodes other than those configured");
    checkPublications();
  }

  private void time(SampleId read, String node) {
    require(time(read) != Long.MAX_VALUE, "a sample that " + node + " could not read");
  }

  private void check(String node, Activation activation, long earliest, long executionTime) {
    boolean inTime = activation.start() >= earliest && activation.start() < Math.max(end, 1);
    boolean asLong = activation.end() == end(node, activation.start(), executionTime);
    require(inTime && asLong && activation.host() >= 0, "an impossible time of " + node);
    for (SampleId read : activation.reads()) {
      require(time(read) <= activation.start(), "a sample that " + node + " could not read");
    }
    for (SampleId sample : activation.writes()) {
      boolean first = written.add(sample);
      require(
          first && time(sample) == activation.end() + delay(node, sample.topic()),
          "a sample that " + node + " could not write");
    }
  }

  /** Returns the time, in ns, by which a fault delays the messages of a node on a topic. */
  private long delay(String node, String topic) {
    JsonNode fault = configuration.path("fault");
    boolean delayed =
        fault.path("change").asText().equals("delayed")
            && fault.path("target").asText().equals(node)
            && fault.path("topic").asText().equals(topic);
    return delayed ? Math.round(fault.path("amount").asDouble() * NANOSECONDS) : 0;
  }

  /** Returns the end of an activation, which a fault may stop or delay. */
  private long end(String node, long start, long executionTime) {
    JsonNode fault = configuration.path("fault");
    long usual = start + executionTime;
    if (!fault.path("target").asText().equals(node)) {
      return usual;
    }
    long from = fault.path("start").asLong();
    long until = fault.path("end").asLong(RunLog.NEVER);
    return switch (fault.path("kind").asText()) {
      case "stop" -> start < from && from <= usual ? usual + until - from : usual;
      case "delay" ->
          start >= from && start < until ? usual + fault.path("amount").asLong() : usual;
      default -> usual;
    };
  }

  /** Returns the publication time of a sample; {@code NEVER} if it was not published. */
  private long time(SampleId sample) {
    Long time = log.publications().getOrDefault(sample.topic(), Map.of()).get(sample.sequence());
    return time == null ? Long.MAX_VALUE : time;
  }

  private void checkPublications() {
    log.publications()
        .forEach(
            (topic, times) -> {
              long sequence = 0;
              for (Map.Entry<Long, Long> publication : times.entrySet()) {
                boolean next = publication.getKey() == sequence++;
                require(
                    next && publication.getValue() >= 0, "samples of " + topic + " are missing");
              }
            });
  }

  /** Checks that the log contains the messages that moved the vehicle. */
  private void checkCommands(List<Outbound> commands) {
    Map<Integer, Map<Long, Integer>> known = new HashMap<>();
    int index = 0;
    for (JsonNode topic : configuration.path("world_subscribes")) {
      Map<Long, Integer> times = new HashMap<>();
      String name = topic.path("topic").asText();
      log.publications()
          .getOrDefault(name, Map.of())
          .values()
          .forEach(time -> times.merge(time, 1, Integer::sum));
      known.put(index++, times);
    }
    for (Outbound command : commands) {
      int left = known.get(command.topic()).merge(command.time(), -1, Integer::sum);
      require(left >= 0, "a command that was never published");
    }
  }

  private static void require(boolean condition, String problem) {
    if (!condition) {
      throw new IllegalArgumentException(problem);
    }
  }
}
