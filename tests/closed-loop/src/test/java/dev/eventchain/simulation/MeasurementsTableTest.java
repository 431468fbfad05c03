package dev.eventchain.simulation;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.simulation.scenario.Scenario;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that the table agrees with the JSON file. */
class MeasurementsTableTest {

  /** A cell, quoted or not, with its delimiter. */
  private static final Pattern CELL =
      Pattern.compile("(?:\"((?:[^\"]|\"\")*)\"|([^\",\r\n]*))(,|\r\n)");

  @TempDir Path folder;

  @Test
  void everyNumberOfTheJsonFileIsARow() throws Exception {
    AebProject project = new AebProject(folder.resolve("package"));
    LatencyConstraint constraint = EventchainFactory.eINSTANCE.createLatencyConstraint();
    constraint.setName("as fast, as it goes");
    constraint.setFirst(project.chain().getSoftware().get(0));
    constraint.setLast(project.chain().getSoftware().get(3));
    constraint.setMaximum(250);
    project.chain().getLatencyConstraints().add(constraint);
    Path file = folder.resolve("formulas.yaml");
    String original =
        Files.readString(AebProject.EXAMPLE.resolve("scenarios/stopped-vehicle-50.yaml"));
    Files.writeString(
        file,
        original.replaceFirst(
            "(?s)accept:.*",
            """
            accept:
              no_impact: true
              formulas:
                - name: keeps "its" speed, at first
                  formula: always[0,1] abs(ego.speed - 50 km/h) <= 5 km/h
            """));
    SimulationResult result =
        project.simulate(
            List.of(Scenario.read(file, AebProject.BENCH), AebProject.scenario("empty-road")));
    List<List<String>> rows = rows(new String(result.toCsv(project.chain()), UTF_8));
    assertEquals(
        List.of(
            "scenario", "subject_kind", "subject", "name", "statistic", "value", "unit", "time_s"),
        rows.get(0));
    List<List<String>> expected = new ArrayList<>();
    JsonNode json = new ObjectMapper().readTree(result.toJson());
    json.path("scenarios").forEach(scenario -> addScenario(scenario, project, expected));
    json.path("nodes").forEach(node -> addNode(node, expected));
    addFlow("", json, expected);
    assertEquals(expected, rows.subList(1, rows.size()));
    assertTrue(rows.toString().contains("keeps \"its\" speed, at first"), rows.toString());
    assertTrue(rows.stream().anyMatch(row -> row.get(1).equals("latency constraint")));
  }

  private static void addScenario(JsonNode json, AebProject project, List<List<String>> rows) {
    String scenario = json.path("name").asText();
    for (JsonNode each : json.path("measurements")) {
      List<String> subject = List.of(scenario, "signal", each.path("name").asText());
      add(rows, subject, "value", each.path("statistic").asText(), each);
    }
    for (JsonNode each : json.path("criteria")) {
      List<String> subject = List.of(scenario, "criterion", each.path("text").asText());
      if (each.has("margin")) {
        add(rows, subject, "margin", "margin", each.path("margin"));
      }
    }
    addStatistics(rows, List.of(scenario, "chain", project.chain().getName()), json, "latency");
    for (int i = 0; i < json.path("latencies").size(); i++) {
      JsonNode each = json.path("latencies").get(i);
      String name = project.chain().getLatencyConstraints().get(i).getName();
      List<String> subject = List.of(scenario, "latency constraint", name);
      addValues(rows, subject, "latency", each);
      for (JsonNode part : each.path("slowest")) {
        String node = part.path("node").asText();
        addTime(rows, subject, "waiting for " + node, "slowest", part.path("waiting"));
        addTime(rows, subject, "execution of " + node, "slowest", part.path("execution"));
      }
    }
    addFlow(scenario, json, rows);
  }

  private static void addFlow(String scenario, JsonNode json, List<List<String>> rows) {
    for (JsonNode hop : json.path("hops")) {
      String name =
          hop.path("topic").asText()
              + " from "
              + hop.path("writer").asText()
              + " to "
              + hop.path("reader").asText();
      List<String> subject = List.of(scenario, "hop", name);
      addStatistics(rows, subject, hop, "waiting");
      addStatistics(rows, subject, hop, "age");
      addCounts(rows, subject, hop.path("samples"));
      for (String limited : List.of("tooOld", "late")) {
        if (hop.path(limited).isObject()) {
          addTime(rows, subject, limited, "limit", hop.path(limited).path("limit"));
          String times = number(hop.path(limited).path("times"));
          addRow(rows, subject, limited, "count", times, "1", "");
          addRow(rows, subject, limited, "of", number(hop.path(limited).path("of")), "1", "");
        }
      }
    }
    for (JsonNode node : json.path("processing")) {
      List<String> subject = List.of(scenario, "node", node.path("name").asText());
      addValues(rows, subject, "processing", node.path("time"));
    }
    for (JsonNode topic : json.path("topics")) {
      addCounts(rows, List.of(scenario, "topic", topic.path("name").asText()), topic);
    }
  }

  private static void addCounts(List<List<String>> rows, List<String> subject, JsonNode counts) {
    counts
        .properties()
        .forEach(
            count -> {
              if (count.getValue().isNumber()) {
                String value = number(count.getValue());
                addRow(rows, subject, count.getKey(), "count", value, "1", "");
              }
            });
  }

  private static void addNode(JsonNode json, List<List<String>> rows) {
    List<String> subject = List.of("", "node", json.path("name").asText());
    addRow(rows, subject, "activations", "count", number(json.path("activations")), "1", "");
    for (String name : List.of("period", "jitter", "executionTime")) {
      addStatistics(rows, subject, json, name);
    }
  }

  private static void addStatistics(
      List<List<String>> rows, List<String> subject, JsonNode json, String name) {
    addValues(rows, subject, name, json.path(name));
  }

  private static void addValues(
      List<List<String>> rows, List<String> subject, String name, JsonNode values) {
    if (values.isObject()) {
      for (String statistic : List.of("minimum", "mean", "median", "percentile99", "maximum")) {
        addTime(rows, subject, name, statistic, values.path(statistic));
      }
      addRow(rows, subject, name, "count", number(values.path("count")), "1", "");
    }
  }

  private static void addTime(
      List<List<String>> rows, List<String> subject, String name, String statistic, JsonNode ms) {
    addRow(rows, subject, name, statistic, number(ms), "ms", "");
  }

  private static void add(
      List<List<String>> rows, List<String> subject, String name, String statistic, JsonNode of) {
    String unit = of.path("unit").asText();
    String time = number(of.path("time"));
    String kind = statistic.toLowerCase(Locale.ROOT);
    addRow(rows, subject, name, kind, number(of.path("value")), unit, time);
  }

  private static void addRow(
      List<List<String>> rows,
      List<String> subject,
      String name,
      String statistic,
      String value,
      String unit,
      String time) {
    List<String> row = new ArrayList<>(subject);
    row.addAll(List.of(name, statistic, value, unit, time));
    rows.add(row);
  }

  private static String number(JsonNode number) {
    if (number.isNull()) {
      return "";
    }
    String plain = number.decimalValue().stripTrailingZeros().toPlainString();
    return number.decimalValue().signum() == 0 ? "0" : plain;
  }

  /** Parses CSV by RFC 4180. */
  private static List<List<String>> rows(String text) {
    List<List<String>> rows = new ArrayList<>();
    List<String> row = new ArrayList<>();
    Matcher cell = CELL.matcher(text);
    int end = 0;
    while (end < text.length()) {
      assertTrue(cell.find(end) && cell.start() == end, text.substring(end));
      String quoted = cell.group(1);
      row.add(quoted == null ? cell.group(2) : quoted.replace("\"\"", "\""));
      if (!cell.group(3).equals(",")) {
        rows.add(List.copyOf(row));
        row.clear();
      }
      end = cell.end();
    }
    return rows;
  }
}
