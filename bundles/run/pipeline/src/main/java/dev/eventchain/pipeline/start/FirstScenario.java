package dev.eventchain.pipeline.start;

import com.fasterxml.jackson.databind.node.TextNode;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.Signal;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.project.Requirements;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * The scenario of a new project, to be changed by people: an approach to a stopped vehicle, or a
 * vehicle that stands, if the bench lets no signal drive it and there is something to switch on;
 * for a robot that takes a speed, something to run into on its way. That nothing is switched on
 * proves nothing by itself, so the second one never passes unchanged.
 *
 * @param name the name of the file without its ending
 * @param text the text of the file
 */
record FirstScenario(String name, String text) {

  /** A consumed topic that drives the vehicle, in a proposed bench. */
  private static final Pattern DRIVES = Pattern.compile("(?s)\nconsumes:\n.*\n    fields:\n");

  /**
   * Returns the scenario.
   *
   * @param bench the proposed bench.yaml
   */
  static FirstScenario of(Requirements requirements, List<Signal> signals, String bench) {
    Optional<String> lamp = DRIVES.matcher(bench).find() ? Optional.empty() : truth(signals);
    String ids = requirements.items().stream().map(WrittenRequirement::id).toList().toString();
    if (bench.contains("{drives: speed")) {
      return robot(ids, judged(requirements, "      "));
    }
    return lamp.map(field -> standing(ids, field, judged(requirements, "        ")))
        .orElseGet(() -> stopped(ids, judged(requirements, "      ")));
  }

  /** Returns the first Boolean that the vehicle receives, as formulas name it. */
  private static Optional<String> truth(List<Signal> signals) {
    return signals.stream()
        .filter(signal -> signal.direction() == Signal.Direction.CONSUMED)
        .flatMap(
            signal ->
                signal.fields().stream()
                    .filter(field -> field.type().equals("bool"))
                    .map(field -> RosNames.resolve(signal.topic(), "") + "." + field.path()))
        .findFirst();
  }

  private static String judged(Requirements requirements, String indent) {
    return requirements.items().stream()
        .map(each -> indent + each.id() + ": " + words(each))
        .collect(Collectors.joining("\n"));
  }

  private static TextNode words(WrittenRequirement requirement) {
    return TextNode.valueOf(requirement.text().strip().replaceAll("\\s+", " "));
  }

  private static FirstScenario standing(String ids, String field, String judged) {
    return new FirstScenario(
        "standing",
        """
        name: standing
        title: The vehicle stands, and nothing happens
        # Set inputs of bench.yaml under 'inputs', drive, or place others on the road, so that something happens.
        requirements: %s
        duration_s: 12
        ego:
          speed_kmh: 0
        accept:
          formulas:
            # Say what has to hold when it happens, and of each requirement quote the words that this judges.
            - name: nothing is switched on
              judges:
        %s
              formula: always[0.5, 12] not %s
        """
            .formatted(ids, judged, field));
  }

  /** Without a command, the robot goes on as it began, and would run into what stands there. */
  private static FirstScenario robot(String ids, String judged) {
    return approach("obstacle-ahead", "Something stands in the way, 8 m ahead", 40, 2, 8)
        .formatted(ids, judged);
  }

  private static FirstScenario stopped(String ids, String judged) {
    return approach("stopped-vehicle", "A stopped vehicle ahead, 50 km/h", 12, 50, 80)
        .formatted(ids, judged);
  }

  /** Returns a scenario without its requirements: something stands ahead, at a distance in m. */
  private static FirstScenario approach(
      String name, String title, int seconds, int kilometresPerHour, int gap) {
    return new FirstScenario(
        name,
        """
        name: %s
        title: %s
        requirements: %%s
        duration_s: %s
        ego:
          speed_kmh: %s
        actors:
          - gap_m: %s
            speed_kmh: 0
        accept:
          no_impact: true
          # Of each requirement, leave the words that no_impact judges, or remove it here and above.
          judges:
            no_impact:
        %%s
        """
            .formatted(name, title, seconds, kilometresPerHour, gap));
  }

  private FirstScenario formatted(String ids, String judged) {
    return new FirstScenario(name, text.formatted(ids, judged));
  }
}
