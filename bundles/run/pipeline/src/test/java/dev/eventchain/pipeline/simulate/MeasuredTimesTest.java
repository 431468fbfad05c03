package dev.eventchain.pipeline.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.verdict.Measurements;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Tests what times measured in real time propose ({@code simulation.time.measured}). */
class MeasuredTimesTest {

  private static final String BASE =
      """
      [
        {
          "name": "Radar",
          "worst_case_execution_time": 1.50e0,
          "memory": 2
        },
        {
          "file": "brake.py",
          "name": "Brake"
        },
        { "name": "Idle", "worst_case_execution_time": 4.9991 },
        { "name": "Absent" }
      ]
      """;

  private static Measurements.Node node(String name, double longest) {
    Measurements.Statistics time = new Measurements.Statistics(3, 0.1, 0.2, 0.2, longest, longest);
    return new Measurements.Node(
        name, 3, Optional.empty(), Optional.empty(), Optional.empty(), Optional.of(time));
  }

  private static MeasuredTimes times(String text, Measurements.Node... nodes) {
    return new MeasuredTimes(
        "base/components.json", SourceText.of("components.json", text), List.of(nodes));
  }

  @Test
  void aLongerTimeReplacesWhatIsStatedAndAMissingOneIsAdded() {
    MeasuredTimes times = times(BASE, node("Radar", 1.5001), node("Brake", 0.2), node("Idle", 4.9));
    assertEquals(
        """
        --- a/base/components.json
        +++ b/base/components.json
        @@ -1,11 +1,12 @@
         [
           {
             "name": "Radar",
        -    "worst_case_execution_time": 1.50e0,
        +    "worst_case_execution_time": 1.51,
             "memory": 2
           },
           {
             "file": "brake.py",
        +    "worst_case_execution_time": 0.2,
             "name": "Brake"
           },
           { "name": "Idle", "worst_case_execution_time": 4.9991 },
        """,
        times.diff().orElseThrow());
    assertEquals(
        List.of(
            "components.json:4: 'Radar' took up to 1.51 ms on this machine, longer than its worst case of 1.50 ms.",
            "components.json:9: 'Brake' took up to 0.2 ms on this machine, and it states no worst case."),
        times.findings().stream()
            .map(it -> it.location().file() + ":" + it.location().line() + ": " + it.message())
            .toList());
    times.findings().forEach(it -> assertEquals("simulation.time.measured", it.kind().id()));
  }

  @Test
  void aPropertyIsAddedInTheLineOfItsName() {
    String diff = times(BASE, node("Absent", 2)).diff().orElseThrow();
    assertTrue(
        diff.contains("+  { \"worst_case_execution_time\": 2, \"name\": \"Absent\" }\n"), diff);
  }

  /** As {@code patch} takes them: it compares what ends a line. */
  @Test
  void endsOfLinesStayAsTheyAre() {
    String windows = "[\r\n  {\r\n    \"name\": \"Brake\"\r\n  }\r\n]\r\n";
    assertEquals(
        """
        @@ -1,5 +1,6 @@
         [\r
           {\r
        +    "worst_case_execution_time": 2,\r
             "name": "Brake"\r
           }\r
         ]\r
        """,
        times(windows, node("Brake", 2))
            .diff()
            .orElseThrow()
            .replaceAll("(?m)^(---|\\+\\+\\+).*\n", ""));
    String open = times("[{\"name\": \"Brake\"}]", node("Brake", 2)).diff().orElseThrow();
    assertTrue(
        open.endsWith(
            """
            -[{"name": "Brake"}]
            \\ No newline at end of file
            +[{"worst_case_execution_time": 2, "name": "Brake"}]
            \\ No newline at end of file
            """),
        open);
  }

  @Test
  void timesWithinWhatIsStatedProposeNothing() {
    MeasuredTimes times = times(BASE, node("Radar", 1.5), node("Idle", 4.999), node("Unknown", 9));
    assertEquals(Optional.empty(), times.diff());
    assertEquals(List.of(), times.findings());
  }

  @Test
  void whatIsNotMeasuredProposesNothing() {
    Measurements.Node silent =
        new Measurements.Node(
            "Brake", 0, Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty());
    assertEquals(Optional.empty(), times(BASE, silent).diff());
  }
}
