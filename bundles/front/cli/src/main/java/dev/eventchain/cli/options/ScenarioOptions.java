package dev.eventchain.cli.options;

import dev.eventchain.pipeline.project.StrengthExtent;
import dev.eventchain.pipeline.run.ScenarioSelection;
import dev.eventchain.pipeline.run.SimulationOptions;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Option;

/** Options for the simulated scenarios and the recordings that are kept. */
public final class ScenarioOptions {

  @Option(
      names = "--scenario",
      paramLabel = "NAME",
      description = "Simulate this scenario only; may be repeated.")
  private List<String> names = List.of();

  @Option(
      names = "--scenario-file",
      paramLabel = "FILE",
      description =
          "Simulate the scenarios of this file instead of the project's, also one in OpenSCENARIO"
              + " XML (.xosc), which needs --accept; may be repeated.")
  private List<Path> files = List.of();

  @Option(
      names = "--accept",
      paramLabel = "CRITERION",
      description =
          "What is required in the .xosc files of --scenario-file: a key of 'accept' in scenarios,"
              + " such as no_impact, never_brakes or maximal_impact_speed_kmh=10; may be repeated.")
  private List<String> accept = List.of();

  /**
   * Returns the scenarios that are simulated.
   *
   * @throws IllegalArgumentException if the options contradict each other
   */
  private ScenarioSelection selection() {
    if (!names.isEmpty() && !files.isEmpty()) {
      throw new IllegalArgumentException(
          "--scenario is about the project's scenarios, and --scenario-file about others");
    }
    if (!accept.isEmpty() && files.isEmpty()) {
      throw new IllegalArgumentException("--accept needs --scenario-file");
    }
    return new ScenarioSelection(names, files, accept);
  }

  @Option(
      names = "--driver",
      paramLabel = "DRIVER",
      description =
          "How the nodes run: 'lockstep' (the default), all in one process, or 'dds', each in a"
              + " process of its own, with Cyclone DDS between them as between nodes of ROS 2, on"
              + " the loopback interface. In simulated time the results are the same.")
  private Transport driver = Transport.LOCKSTEP;

  @Option(
      names = "--real-time",
      description =
          "With --driver dds, let nodes run in wall-clock time: execution times are real, and a"
              + " scenario takes as long as it takes. If this machine cannot keep up with the"
              + " world, a scenario is not judged.")
  private boolean realTime;

  @Option(
      names = "--attach",
      description =
          "With --driver dds, start no nodes, but drive those that were started elsewhere, in ROS 2"
              + " or without, in the domain of ROS_DOMAIN_ID, in wall-clock time. CYCLONEDDS_URI"
              + " and ROS_LOCALHOST_ONLY apply. What happens inside such nodes is not measured.")
  private boolean attach;

  private enum Transport {
    LOCKSTEP,
    DDS
  }

  /**
   * Returns the driver of the nodes.
   *
   * @throws IllegalArgumentException if the options contradict each other
   */
  private SimulationOptions.Driver driver() {
    if (attach && driver != Transport.DDS) {
      throw new IllegalArgumentException("--attach needs --driver dds");
    }
    if (realTime && driver != Transport.DDS) {
      throw new IllegalArgumentException("--real-time needs --driver dds");
    }
    if (attach) {
      return SimulationOptions.Driver.DDS_ATTACHED;
    }
    return driver == Transport.LOCKSTEP
        ? SimulationOptions.Driver.LOCKSTEP
        : realTime ? SimulationOptions.Driver.DDS_IN_REAL_TIME : SimulationOptions.Driver.DDS;
  }

  @Option(
      names = "--mcap",
      description =
          "Also record every message of each scenario, and where everything is on the road, in"
              + " OUTPUT/mcap/NAME.mcap, for Foxglove, 'ros2 bag' and rosbags: about 1 MB for each"
              + " simulated second with a lidar. Scenarios are simulated even if nothing has"
              + " changed.")
  private boolean mcap;

  @Option(
      names = "--faults",
      paramLabel = "FILE",
      description =
          "Also simulate scenarios with the faults that this file describes (YAML; its schema is"
              + " that of 'bench --faults-schema'): a node that dies, messages that get lost, a"
              + " clock that jumps. Each fault gets a run of its own, in addition to the scenario"
              + " without it.")
  private Path faults;

  @Option(
      names = "--strength",
      paramLabel = "EXTENT",
      arity = "0..1",
      fallbackValue = "SAMPLE",
      description =
          "Measure how many standard faults of its components each requirement's criteria notice:"
              + " drives of scenarios with each fault, until one notices it. 'sample' (the default,"
              + " unless the project says otherwise) drives as many faults as a budget of simulated"
              + " time allows, 'whole' all, 'off' none. A verdict says which it was.")
  private StrengthExtent strength;

  @Option(names = "--no-strength", description = "The same as --strength=off.")
  private boolean noStrength;

  /**
   * Returns the wanted extent of strength; empty: as the project says.
   *
   * @throws IllegalArgumentException if the options contradict each other
   */
  private Optional<StrengthExtent> strength() {
    if (noStrength && strength != null && strength != StrengthExtent.OFF) {
      throw new IllegalArgumentException("--no-strength contradicts --strength=" + strength.word());
    }
    return noStrength ? Optional.of(StrengthExtent.OFF) : Optional.ofNullable(strength);
  }

  /**
   * Returns what they say together.
   *
   * @throws IllegalArgumentException if they contradict each other
   */
  public SimulationOptions simulation() {
    return new SimulationOptions(selection(), driver(), mcap, faults(), strength());
  }

  /** Returns whether none of them is given. */
  public boolean areDefault() {
    return names.isEmpty()
        && files.isEmpty()
        && accept.isEmpty()
        && driver == Transport.LOCKSTEP
        && !realTime
        && !attach
        && !mcap
        && faults == null
        && strength == null
        && !noStrength
        && compare == null;
  }

  @Option(
      names = "--compare",
      paramLabel = "FILE",
      description =
          "Show next to each scenario in the report what another run measured: its "
              + "measurements.json, or the folder of its results.")
  private Path compare;

  /** Returns the earlier run that the report shows beside this one. */
  public Optional<Path> compared() {
    return Optional.ofNullable(compare);
  }

  /** Returns options that name a file of faults, if there is one. */
  public static ScenarioOptions ofFaults(Path faults) {
    ScenarioOptions options = new ScenarioOptions();
    options.faults = faults;
    return options;
  }

  /** Returns the file of faults that are simulated. */
  public Optional<Path> faults() {
    return Optional.ofNullable(faults);
  }

  /** Returns whether messages are recorded. */
  public boolean areRecorded() {
    return mcap;
  }

  /** Returns whether nodes are driven that were started elsewhere. */
  public boolean areAttached() {
    return attach;
  }
}
