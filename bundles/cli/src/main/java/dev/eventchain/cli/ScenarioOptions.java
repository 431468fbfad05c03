package dev.eventchain.cli;

import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Option;

/** What is simulated, and what is kept of it. */
final class ScenarioOptions {

  @Option(
      names = "--scenario",
      paramLabel = "NAME",
      description = "Simulate this scenario only; may be repeated.")
  List<String> scenarios = List.of();

  @Option(
      names = "--mcap",
      description = {
        "Also record every message of each scenario, and where everything is on the road, in",
        "OUTPUT/mcap/NAME.mcap, for Foxglove, 'ros2 bag' and rosbags: about 1 MB for each",
        "simulated second with a lidar. Scenarios are simulated even where nothing has changed."
      })
  boolean mcap;

  @Option(
      names = "--compare",
      paramLabel = "FILE",
      description = {
        "Show beside each scenario in the report what another run measured: its",
        "measurements.json, or the folder of its results."
      })
  Path compare;
}
