package dev.eventchain.documentation;

import dev.eventchain.pipeline.campaign.Campaigns;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.bench.WorldReference;
import dev.eventchain.simulation.fault.FaultPlan;
import dev.eventchain.simulation.scenario.Scenario;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Tables of what benches, scenarios, formulas and faults may say, from what the program reads. A
 * page has a comment in place of each; {@code <!-- file NAME -->} stands for a file of an example,
 * which builds run.
 */
final class SimulationReference {

  private static final Pattern PLACE = Pattern.compile("<!-- (\\w+)(?: ([\\w./-]+))? -->\n");

  private SimulationReference() {}

  /** Returns a page with the tables and files in place of its comments. */
  static String inserted(String page, Path root) throws IOException {
    Matcher place = PLACE.matcher(page);
    StringBuilder text = new StringBuilder();
    while (place.find()) {
      String content =
          place.group(2) == null
              ? table(place.group(1))
              : "```yaml\n" + Files.readString(root.resolve(place.group(2))) + "```\n";
      place.appendReplacement(text, Matcher.quoteReplacement(content));
    }
    return place.appendTail(text).toString();
  }

  private static String table(String name) {
    return switch (name) {
      case "quantities" -> entries(WorldReference.quantities());
      case "actor" -> entries(WorldReference.actorQuantities());
      case "objects" -> entries(WorldReference.objectProperties());
      case "actuators" -> entries(WorldReference.actuators());
      case "operators" -> operators();
      case "bench" -> SchemaTable.of(Bench.schema(), "", "");
      case "scenario" -> SchemaTable.of(Scenario.schema(), "", "accept");
      case "criteria" -> SchemaTable.of(Scenario.schema(), "accept", "");
      case "campaign" -> SchemaTable.of(Campaigns.schema(), "", "");
      case "openscenario" -> features();
      case "faults" -> SchemaTable.of(FaultPlan.schema(), "", "");
      default -> throw new IllegalArgumentException("There is no table '" + name + "'.");
    };
  }

  private static String entries(List<WorldReference.Entry> entries) {
    StringBuilder text = new StringBuilder("| name | unit | |\n|---|---|---|\n");
    for (WorldReference.Entry entry : entries) {
      String unit = entry.unit().isEmpty() ? "true or false" : entry.unit();
      text.append("| `%s` | %s | %s |\n".formatted(entry.name(), unit, entry.meaning()));
    }
    return text.toString();
  }

  /** Returns what is not supported of OpenSCENARIO XML, by the elements of the standard. */
  private static String features() {
    StringBuilder text = new StringBuilder("| what | | why |\n|---|---|---|\n");
    for (WorldReference.FeatureEntry each : WorldReference.unsupportedFeatures()) {
      text.append("| %s | %s | %s |\n".formatted(each.names(), each.support(), each.reason()));
    }
    return text.toString();
  }

  private static String operators() {
    StringBuilder text = new StringBuilder("| written | | example |\n|---|---|---|\n");
    for (WorldReference.OperatorEntry each : WorldReference.operators()) {
      text.append(
          "| `%s` | %s | `%s` |\n".formatted(each.written(), each.meaning(), each.example()));
    }
    return text.toString();
  }
}
