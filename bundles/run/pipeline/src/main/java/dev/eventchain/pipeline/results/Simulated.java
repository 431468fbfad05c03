package dev.eventchain.pipeline.results;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;

/**
 * The report of a simulation.
 *
 * @param confinement the confinement of the components
 * @param python the version of Python
 * @param driver the driver and its speed
 * @param attached the driver of nodes that were started elsewhere, if they were
 * @param latencies that of the chain, and those of the constraints
 * @param processors those to which components are mapped
 * @param signals the values of the signals of the chain; empty in a simulation of some scenarios
 * @param untested the qualified names of constraints that implement a requirement and were not
 *     tested
 * @param requirements the outcome of each requirement; empty in a simulation of some scenarios
 * @param strength why the strength of requirements was not measured, or the size of its sample;
 *     empty if all faults were driven
 * @param validation the results of the constraints on the measured model
 */
public record Simulated(
    String confinement,
    String python,
    String driver,
    Optional<String> attached,
    List<SimulatedScenario> scenarios,
    @JsonInclude(JsonInclude.Include.NON_EMPTY) List<SimulatedFault> faults,
    List<Node> nodes,
    List<Hop> hops,
    List<Topic> topics,
    List<BoundedLatency> latencies,
    @JsonInclude(JsonInclude.Include.NON_EMPTY) List<LoadedProcessor> processors,
    @JsonInclude(JsonInclude.Include.NON_EMPTY) List<ShownSignal> signals,
    List<String> untested,
    List<RequirementOutcome> requirements,
    Optional<String> strength,
    Validation validation)
    implements StageReport {

  /** Copies the lists; JSON omits empty ones of faults, processors and signals. */
  public Simulated {
    scenarios = List.copyOf(scenarios);
    faults = faults == null ? List.of() : List.copyOf(faults);
    nodes = List.copyOf(nodes);
    hops = List.copyOf(hops);
    topics = List.copyOf(topics);
    latencies = List.copyOf(latencies);
    processors = processors == null ? List.of() : List.copyOf(processors);
    signals = signals == null ? List.of() : List.copyOf(signals);
    untested = List.copyOf(untested);
    requirements = List.copyOf(requirements);
  }

  /** The measurements of a node; a distribution without values is empty. */
  public record Node(
      String name,
      int activations,
      Optional<Statistics> period,
      Optional<Statistics> jitter,
      Optional<Statistics> executionTime,
      Optional<Statistics> hostExecutionTime,
      OptionalDouble timesWorstCase) {}

  /** A topic from one of its writers to one of its readers; unknown values are empty. */
  public record Hop(
      String topic,
      String writer,
      String reader,
      Optional<Statistics> waiting,
      Optional<Statistics> age,
      Optional<Samples> samples,
      Optional<Exceeded> tooOld,
      Optional<Exceeded> late) {}

  /** The fate of samples. */
  public record Samples(long published, long read, long neverRead, long unreadAtEnd) {}

  /** The number of times that a limit in ms was exceeded. */
  public record Exceeded(double limit, long times, long of) {}

  /** The messages of a topic; unknown numbers are empty. */
  public record Topic(
      String name, OptionalLong published, OptionalLong dropped, OptionalLong lost) {}
}
