package dev.eventchain.simulation.formula;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.world.States;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Tests that formulas agree with rtamt (Nickovic and Yamaguchi, RTAMT, ATVA 2020): 600 random ones
 * against its robustness, as recorded by {@code src/test/python/random_formulas.py}.
 */
class RtamtTest {

  @Test
  void robustnessIsThatOfRtamt() throws IOException {
    List<String> lines = Files.readAllLines(Path.of("src/test/resources/formulas/rtamt.jsonl"));
    int decided = 0;
    for (String line : lines) {
      JsonNode recorded = new ObjectMapper().readTree(line);
      Trace trace = new Trace();
      for (int i = 0; i < recorded.get(1).size(); i++) {
        trace.state(States.of(i * World.TRACE_STEP, recorded.get(1).get(i).asDouble(), 1, 1, 0));
      }
      String text = recorded.get(0).asText();
      Formula formula = Formula.parse(SourceText.of("f", text).whole(), new WorldSignals(), 10);
      double truth = FormulaEvaluation.of(formula.condition(), new SampledRun(trace)).verdict();
      double expected = recorded.get(2).asDouble();
      assertEquals(Math.abs(expected), Robustness.margin(truth), 1e-9, text);
      // A margin of 0 has no sign, neither here nor in rtamt.
      if (expected != 0) {
        assertEquals(Math.signum(expected), Math.signum(truth), text);
        decided++;
      }
    }
    assertEquals(600, lines.size());
    assertTrue(decided > 400, decided + " decided");
  }
}
