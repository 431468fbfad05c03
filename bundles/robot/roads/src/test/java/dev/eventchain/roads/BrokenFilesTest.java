package dev.eventchain.roads;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.roads.road.Pose;
import dev.eventchain.roads.road.Road;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** Files with random damage: a network, or findings with their places. */
class BrokenFilesTest {

  private static final List<String> TEXTS =
      List.of(
          SourceText.read(Networks.FOLDER.resolve("tilted.xodr")).text(),
          SourceText.read(Networks.FOLDER.resolve("leaving.xodr")).text());

  /** Replacements of a piece of the text. */
  private static final List<String> DAMAGES =
      List.of("", "-", "0", "1e308", "NaN", "-1e-9", "\"", "<", ">", "/>", "&", "x", "\u0000", "é");

  @Property
  void damageIsFoundOrHarmless(
      @ForAll @IntRange(max = 1) int text,
      @ForAll @IntRange(max = 99_999) int place,
      @ForAll @IntRange(max = 12) int length,
      @ForAll @IntRange(max = 13) int damage) {
    String whole = TEXTS.get(text);
    int from = place % whole.length();
    int to = Math.min(whole.length(), from + length);
    String broken = whole.substring(0, from) + DAMAGES.get(damage) + whole.substring(to);
    try {
      RoadNetwork network = RoadNetwork.parse(SourceText.of("broken.xodr", broken));
      for (Road road : network.roads()) {
        Pose pose = road.pose(road.length() / 2, 0);
        assertTrue(Double.isFinite(pose.x() + pose.y() + pose.z() + pose.heading()));
      }
    } catch (DiagnosticException e) {
      for (Diagnostic found : e.diagnostics()) {
        assertFalse(found.hint().isEmpty(), found.toString());
        assertTrue(found.id().startsWith("road."), found.toString());
      }
    }
  }
}
