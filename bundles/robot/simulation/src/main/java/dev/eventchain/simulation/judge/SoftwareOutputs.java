package dev.eventchain.simulation.judge;

import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.bench.BenchSignals;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.formula.WorldSignals;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.world.Actuator;
import dev.eventchain.simulation.world.Trace;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/** Outputs of the software as signals of formulas, and whether it ever does something with them. */
final class SoftwareOutputs {

  private static final Actuator[] STEERING = {Actuator.STEERING, Actuator.STEERING_ANGLE};
  private static final Actuator[] TURNING = {
    Actuator.STEERING, Actuator.STEERING_ANGLE, Actuator.YAW_RATE
  };

  private static final Set<Actuator> MOVING = Set.of(Actuator.ACCELERATION, Actuator.SPEED);

  private final SimulatedChain chain;
  private final List<ScenarioRun> runs;

  /** Creates the outputs of the software in all runs of a simulation. */
  SoftwareOutputs(SimulatedChain chain, List<ScenarioRun> runs) {
    this.chain = chain;
    this.runs = runs;
  }

  /** Returns the signals that components write, among those that are read and their origins. */
  Set<String> among(Collection<Signal> read) {
    return read.stream()
        .flatMap(Signal::origins)
        .filter(this::isOutput)
        .map(Signal::name)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private boolean isOutput(Signal signal) {
    return (signal.topic().isPresent() || isCommand(signal.name())) && dependsOnSoftware(signal);
  }

  private static boolean isCommand(String signal) {
    return signal.equals("brake") || signal.equals("throttle") || signal.equals("steering");
  }

  /** Returns whether the chain can influence a signal. */
  boolean dependsOnSoftware(Signal signal) {
    Optional<BenchSignals.Topic> topic = chain.bench().signals().topicOf(signal);
    if (topic.isPresent()) {
      return chain.isWritten(topic.get().name(), signal.field());
    }
    return switch (signal.name()) {
      case "brake" -> chain.drives(Actuator.BRAKE, Actuator.ACCELERATION);
      case "throttle" -> chain.drives(Actuator.THROTTLE, Actuator.ACCELERATION);
      case "lane.width", "lane.curvature" -> false;
      case "steering" -> chain.drives(STEERING);
      case "ego.offset",
          "ego.heading",
          "ego.yaw_rate",
          "ego.acceleration.left",
          "lane.left",
          "lane.right" ->
          chain.drives(TURNING);
      default ->
          signal.basis().isEmpty()
              ? WorldSignals.isKnown(signal.name()) && chain.drives(Actuator.values())
              : signal.basis().stream().anyMatch(this::dependsOnSoftware);
    };
  }

  /**
   * Returns the outputs that differ from 0 and false at some time in some scenario. A text has no
   * such value: it has to change, or to be written in some runs only.
   */
  Set<String> active(Set<String> outputs) {
    return outputs.stream().filter(this::isActive).collect(Collectors.toCollection(TreeSet::new));
  }

  private boolean isActive(String output) {
    if (isText(output)) {
      List<Set<Double>> written = runs.stream().map(run -> values(run, output)).toList();
      return written.stream().distinct().count() > 1
          || written.stream().anyMatch(each -> each.size() > 1);
    }
    return switch (actuated(output)) {
      case "brake" -> everCommanded(Trace.Command::brakes);
      case "throttle" -> everCommanded(command -> command.throttle() != 0.0);
      case "steering" -> everCommanded(command -> command.steering() != 0.0);
      default ->
          runs.stream()
              .flatMap(run -> run.trace().samples(output).stream())
              .anyMatch(sample -> sample.value() != 0.0 && !Double.isNaN(sample.value()));
    };
  }

  private boolean isText(String output) {
    return chain.bench().signals().find(output).filter(it -> it.named().isText()).isPresent();
  }

  private static Set<Double> values(ScenarioRun run, String output) {
    return run.trace().samples(output).stream()
        .map(Trace.Sample::value)
        .filter(value -> !value.isNaN())
        .collect(Collectors.toSet());
  }

  /** Returns whether there is such a command in some scenario. */
  boolean everCommanded(Predicate<Trace.Command> kind) {
    return runs.stream().flatMap(run -> run.trace().commands().stream()).anyMatch(kind);
  }

  /** Returns the pedal or wheel that an output drives; the output itself if it drives neither. */
  private String actuated(String output) {
    return chain.bench().consumed().values().stream()
        .filter(topic -> topic.topic().equals(Signal.topicOf(output)))
        .flatMap(topic -> topic.fields().stream())
        .filter(field -> output.equals(Signal.topicOf(output) + "." + field.path()))
        .flatMap(field -> field.actuator().stream())
        .map(actuator -> pedalOrWheel(actuator, output))
        .findFirst()
        .orElse(output);
  }

  private static String pedalOrWheel(Actuator actuator, String output) {
    return switch (actuator) {
      case BRAKE -> "brake";
      case THROTTLE -> "throttle";
      case STEERING, STEERING_ANGLE -> "steering";
      default -> output;
    };
  }

  /** Returns the components that write some outputs. */
  Set<String> writers(Collection<String> outputs) {
    return outputs.stream()
        .flatMap(output -> topicsOf(output).stream())
        .flatMap(topic -> chain.writers(topic).stream())
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private Collection<String> topicsOf(String output) {
    if (!isCommand(output)) {
      return List.of(Signal.topicOf(output));
    }
    return chain.bench().consumed().values().stream()
        .filter(topic -> topic.fields().stream().anyMatch(field -> drives(topic, field, output)))
        .map(Bench.Consumed::topic)
        .toList();
  }

  private boolean drives(Bench.Consumed topic, Bench.Effect field, String command) {
    return field.actuator().isPresent()
        && chain.isWritten(topic.topic(), field.path())
        && (pedalOrWheel(field.actuator().get(), "").equals(command)
            || (MOVING.contains(field.actuator().get()) && !command.equals("steering"))
            || (field.actuator().get() == Actuator.YAW_RATE && command.equals("steering")));
  }
}
