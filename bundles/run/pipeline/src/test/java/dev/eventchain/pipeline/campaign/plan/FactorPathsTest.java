package dev.eventchain.pipeline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.SourceText;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** The numbers of scenarios and benches by the paths that factors have. */
class FactorPathsTest {

  private static SourceText yaml(String text) {
    return SourceText.of("a.yaml", text);
  }

  @Test
  void elementsOfListsHaveTheirNamesIfTheseAreTheirOwn() {
    assertEquals(
        Map.of(
            "seed", "3",
            "actors[lead].gap_m", "80",
            "actors[1].gap_m", "7.5",
            "actors[2].gap_m", "8",
            "actors[3].maneuvers[0].after_s", "1"),
        FactorPaths.ofScenario(
            yaml(
                """
                name: x
                seed: 3
                actors:
                - {name: lead, gap_m: 80}
                - {name: twin, gap_m: 7.5}
                - {name: twin, gap_m: 8}
                - maneuvers: [{after_s: 1, kind: stop}]
                """)));
  }

  /** A key may have dots, but no brackets. */
  @Test
  void eachPathIsReadAsItIsMeant() {
    assertEquals(
        List.of("bench:inputs.radar.reach.value"),
        List.copyOf(
            FactorPaths.ofBench(yaml("inputs:\n  radar.reach: {value: 150}\n  'a[b': 1\n"))
                .keySet()));
  }

  @Test
  void aTextThatCannotBeReadHasNone() {
    assertEquals(Map.of(), FactorPaths.ofScenario(yaml("a: [1")));
    assertEquals(Map.of(), FactorPaths.ofScenario(yaml("- 1\n")));
  }
}
