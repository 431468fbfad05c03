package dev.eventchain.cli;

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
}
