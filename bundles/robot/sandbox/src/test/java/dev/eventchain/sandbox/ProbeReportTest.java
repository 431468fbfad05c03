package dev.eventchain.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Reports without findings, and their results of the requested calls. */
class ProbeReportTest {
  private static final SourceText SOURCE = SourceText.of("Brake.py", "class Brake: pass\n");

  private static List<CallResults> results(String results) {
    String output = "{\"findings\": []" + results + "}";
    var end = new ConfinedProcess.Termination(ConfinedProcess.Cause.EXITED, 0);
    return new ProbeReport(output, end, "").results(SOURCE, 2);
  }

  @Test
  void eachSequenceOfCallsHasAResult() {
    List<CallResults> results = results(", \"results\": [{\"outputs\": [{\"force\": 1}]}, {}]");
    assertEquals(2, results.size());
    assertTrue(results.stream().allMatch(each -> each.problem().isEmpty()));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", ", \"results\": []", ", \"results\": [{}]", ", \"results\": [{},{},{}]"})
  void anotherNumberOfResultsIsAProblem(String results) {
    Optional<Diagnostic> problem = results(results).get(0).problem();
    assertEquals("component.ended", problem.orElseThrow().id());
    assertTrue(problem.get().message().endsWith(" of 2 sequences of calls."));
  }
}
