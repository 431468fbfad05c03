package dev.eventchain.simulation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.model.eventchain.EventChain;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/**
 * What to simulate.
 *
 * @param chain the chain whose nodes were generated
 * @param packageFolder the folder that holds the manifest and the generated Python package
 * @param manifest what was generated
 * @param messageFolders folders with the user's message definitions, {@code <package>/msg/*.msg}
 * @param bench how the world and the nodes are connected
 * @param scenarios at least one
 * @param processes how many scenarios are simulated at the same time, at least 1; the result does
 *     not depend on it
 * @param generated names of the components that were generated and have to keep to the rules of
 *     such; the others are people's own
 * @param limits what the nodes and their components may use
 * @param accepted whether people have decided to live with a finding: a component that did not work
 *     keeps criteria from being judged only if they have not
 * @param recordings an existing folder that gets the messages of each scenario, in {@code
 *     NAME.mcap} once the scenario has ended, also by a failure of a node; empty: nothing is
 *     recorded
 * @param driver how the nodes are run
 * @param faults what else is simulated: each fault in one more run of its scenario, which is one of
 *     the scenarios
 * @param attachment where to find the nodes that are run elsewhere; there with {@link
 *     Driver#DDS_ATTACHED} only
 */
public record SimulationRequest(
    EventChain chain,
    Path packageFolder,
    NodeManifest manifest,
    List<Path> messageFolders,
    Bench bench,
    List<Scenario> scenarios,
    int processes,
    Set<String> generated,
    Limits limits,
    Predicate<Diagnostic> accepted,
    Optional<Path> recordings,
    Driver driver,
    FaultPlan faults,
    Optional<Attachment> attachment) {

  /** What brings messages from one to another, and lets time pass. */
  public enum Driver {
    /** All nodes in one process, messages in memory. */
    LOCKSTEP("lock-step"),
    /**
     * Each node in its own process on Cyclone DDS, in simulated time. Faults that kill or stop a
     * node act within its host, at an instant of simulated time, so that they do the same as in
     * lock-step; the host itself continues.
     */
    DDS("Cyclone DDS in simulated time"),
    /** The same in real time: one scenario after the other, and no node waits for another. */
    DDS_IN_REAL_TIME("Cyclone DDS in real time"),
    /** No node is started here: others run them, in real time. */
    DDS_ATTACHED("Cyclone DDS, attached");

    private final String words;

    Driver(String words) {
      this.words = words;
    }

    /** For people: what it is. */
    public String words() {
      return words;
    }
  }

  /**
   * Where to find nodes that are run elsewhere.
   *
   * @param domain the number of the DDS domain
   * @param configuration of Cyclone DDS, XML or what {@code CYCLONEDDS_URI} may hold; empty for its
   *     defaults
   */
  public record Attachment(int domain, String configuration) {

    /**
     * As the environment says, as for nodes of ROS 2: {@code ROS_DOMAIN_ID}, {@code
     * CYCLONEDDS_URI}, and the loopback interface only if {@code ROS_LOCALHOST_ONLY} is 1 or {@code
     * ROS_AUTOMATIC_DISCOVERY_RANGE} is LOCALHOST.
     *
     * @throws dev.eventchain.diagnostics.DiagnosticException (INPUT) {@code dds.domain.unusable}:
     *     there is no such domain
     */
    public static Attachment of(Map<String, String> environment) {
      return AttachedHosts.attachment(environment);
    }

    /** For people: what drives the nodes. */
    String words() {
      return Driver.DDS_ATTACHED.words() + " to domain " + domain;
    }
  }

  /**
   * What foreign code may use before it counts as hanging. Processor time does not depend on what
   * else this machine does.
   *
   * @param processorTime of a component for one call, and of a node between two messages of a
   *     sensor
   * @param wallTime on the clock for the same, for code that waits: much longer
   * @param run on the clock for all scenarios together
   */
  public record Limits(Duration processorTime, Duration wallTime, Duration run) {

    /** Ten seconds of processor time, a minute for code that waits, an hour for all. */
    public static final Limits DEFAULT =
        new Limits(Duration.ofSeconds(10), Duration.ofMinutes(1), Duration.ofHours(1));
  }

  /** Copies the lists; refuses a request without scenario or process. */
  public SimulationRequest {
    messageFolders = List.copyOf(messageFolders);
    scenarios = List.copyOf(scenarios);
    generated = Set.copyOf(generated);
    if (scenarios.isEmpty() || processes < 1) {
      throw new IllegalArgumentException("a simulation needs a scenario and a process");
    }
    if (attachment.isPresent() != (driver == Driver.DDS_ATTACHED)) {
      throw new IllegalArgumentException("attaching needs a domain");
    }
  }

  /** With two processes and the default limits; no component counts as generated. */
  public static SimulationRequest of(
      EventChain chain,
      Path packageFolder,
      NodeManifest manifest,
      List<Path> messageFolders,
      Bench bench,
      List<Scenario> scenarios) {
    return new SimulationRequest(
        chain,
        packageFolder,
        manifest,
        messageFolders,
        bench,
        scenarios,
        2,
        Set.of(),
        Limits.DEFAULT,
        finding -> false,
        Optional.empty(),
        Driver.LOCKSTEP,
        FaultPlan.NONE,
        Optional.empty());
  }

  /** The same on another number of processes. */
  public SimulationRequest withProcesses(int number) {
    return with(number, generated, limits, accepted, recordings, driver, faults, attachment);
  }

  /** The same with other components that count as generated. */
  public SimulationRequest withGenerated(Set<String> names) {
    return with(processes, names, limits, accepted, recordings, driver, faults, attachment);
  }

  /** The same with other limits. */
  public SimulationRequest withLimits(Limits other) {
    return with(processes, generated, other, accepted, recordings, driver, faults, attachment);
  }

  /** The same with other findings that people accept. */
  public SimulationRequest withAccepted(Predicate<Diagnostic> other) {
    return with(processes, generated, limits, other, recordings, driver, faults, attachment);
  }

  /** The same with recordings in a folder, which exists. */
  public SimulationRequest withRecordings(Path folder) {
    return with(
        processes, generated, limits, accepted, Optional.of(folder), driver, faults, attachment);
  }

  /** The same with another driver, which starts the nodes. */
  public SimulationRequest withDriver(Driver other) {
    return with(
        processes, generated, limits, accepted, recordings, other, faults, Optional.empty());
  }

  /** The same with faults, each in a scenario of this request. */
  public SimulationRequest withFaults(FaultPlan other) {
    return with(processes, generated, limits, accepted, recordings, driver, other, attachment);
  }

  /** The same with nodes that are run elsewhere. */
  public SimulationRequest withAttachment(Attachment where) {
    return with(
        1,
        generated,
        limits,
        accepted,
        recordings,
        Driver.DDS_ATTACHED,
        faults,
        Optional.of(where));
  }

  /** For people: what brings messages from one node to another. */
  String driverWords() {
    return attachment.map(Attachment::words).orElse(driver.words());
  }

  private SimulationRequest with(
      int number,
      Set<String> names,
      Limits newLimits,
      Predicate<Diagnostic> newAccepted,
      Optional<Path> newRecordings,
      Driver newDriver,
      FaultPlan newFaults,
      Optional<Attachment> newAttachment) {
    return new SimulationRequest(
        chain,
        packageFolder,
        manifest,
        messageFolders,
        bench,
        scenarios,
        number,
        names,
        newLimits,
        newAccepted,
        newRecordings,
        newDriver,
        newFaults,
        newAttachment);
  }
}
