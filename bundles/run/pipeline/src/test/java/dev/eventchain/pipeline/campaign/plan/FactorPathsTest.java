package dev.eventchain.pipeline.campaign.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceText;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
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

  /**
   * Time grows with the numbers only: each of these had the whole text copied, which took minutes.
   */
  @Test
  void manyNumbersHaveTheirPaths() {
    StringBuilder text = new StringBuilder("actors:\n");
    for (int i = 0; i < 5_000; i++) {
      text.append("- {name: a").append(i).append(", gap_m: ").append(i).append("}\n");
    }
    ThreadMXBean clock = ManagementFactory.getThreadMXBean();
    long start = clock.getCurrentThreadCpuTime();
    Map<String, String> paths = FactorPaths.ofScenario(yaml(text.toString()));
    assertEquals("4999", paths.get("actors[a4999].gap_m"));
    assertEquals(5_000, paths.size());
    long seconds = (clock.getCurrentThreadCpuTime() - start) / 1_000_000_000;
    assertTrue(seconds < 5, seconds + " s");
  }

  @Test
  void aTextThatCannotBeReadHasNone() {
    assertEquals(Map.of(), FactorPaths.ofScenario(yaml("a: [1")));
    assertEquals(Map.of(), FactorPaths.ofScenario(yaml("- 1\n")));
  }
}
