package dev.eventchain.contracts.timing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Bounds for timers of one clock that are released when what they wait for has arrived. */
class AlignedTimersTest {

  @Test
  void timersThatFollowEachOtherSaveTheWaitingBetweenThem() {
    List<Task> path =
        List.of(
            Task.periodic("camera", 50, 10),
            Task.periodic("fusion", 50, 45),
            Task.periodic("brake", 50, 2));
    AlignedTimers aligned = aligned(path).orElseThrow();
    assertEquals(Map.of("camera", 0L, "fusion", 10L, "brake", 5L), aligned.phases());
    assertEquals(50 + 10 + 45 + 2, aligned.bound().time());
    assertTrue(aligned(List.of(Task.onMessage("filter", 1))).isEmpty());
    AlignedTimers apart =
        aligned(List.of(path.get(0), Task.onMessage("way", 7), path.get(1))).orElseThrow();
    assertEquals(Map.of("camera", 0L, "fusion", 17L), apart.phases());
    assertEquals(50 + 10 + 7 + 45, apart.bound().time());
  }

  private static Optional<AlignedTimers> aligned(List<Task> path) {
    return AlignedTimers.of(
        LatencyType.REACTION, List.of(PathLatency.of(LatencyType.REACTION, path)));
  }

  /** The brake follows the slower path, so that the other one may just miss it. */
  @ParameterizedTest
  @CsvSource({"100, 5, 116", "50, 20, 216"})
  void alignedTimersCountOnAllPaths(long period, long response, long expected) {
    TaskGraph graph = new TaskGraph();
    graph.add(Task.periodic("camera", 100, 5));
    graph.add(Task.periodic("fusion", 100, 6));
    graph.add(Task.periodic("radar", period, response));
    graph.add(Task.periodic("brake", 100, 5));
    for (String way : List.of("fusion", "radar")) {
      graph.connect("camera", way);
      graph.connect(way, "brake");
    }
    List<PathLatency> paths = graph.between(LatencyType.REACTION, "camera", "brake").orElseThrow();
    AlignedTimers aligned = AlignedTimers.of(LatencyType.REACTION, paths).orElseThrow();
    assertEquals(Map.of("camera", 0L, "fusion", 5L, "radar", 5L, "brake", 11L), aligned.phases());
    assertEquals(expected, aligned.bound().time());
  }
}
