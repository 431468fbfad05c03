package dev.eventchain.pipeline.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceText;
import java.util.List;
import java.util.Map;
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

  private static MeasuredTimes times(String text, Map<String, Double> longest) {
    return new MeasuredTimes(
        "base/components.json", SourceText.of("components.json", text), longest);
  }

  @Test
  void aLongerTimeReplacesWhatIsStatedAndAMissingOneIsAdded() {
    MeasuredTimes times = times(BASE, Map.of("Radar", 1.5001, "Brake", 0.2, "Idle", 4.9));
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
    String diff = times(BASE, Map.of("Absent", 2.0)).diff().orElseThrow();
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
        times(windows, Map.of("Brake", 2.0))
            .diff()
            .orElseThrow()
            .replaceAll("(?m)^(---|\\+\\+\\+).*\n", ""));
    String open = times("[{\"name\": \"Brake\"}]", Map.of("Brake", 2.0)).diff().orElseThrow();
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
    MeasuredTimes times = times(BASE, Map.of("Radar", 1.5, "Idle", 4.999, "Unknown", 9.0));
    assertEquals(Optional.empty(), times.diff());
    assertEquals(List.of(), times.findings());
  }

  @Test
  void whatIsNotMeasuredProposesNothing() {
    assertEquals(Optional.empty(), times(BASE, Map.of()).diff());
  }
}
