package dev.eventchain.pipeline.results;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.StageRecord;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Tests that records are read and written as they are, and strictly. */
class ResultJsonTest {

  private static final JsonMapper MAPPER = new JsonMapper();

  /** Keys that stand for nothing where they are missing. */
  private static final Set<String> OPTIONAL =
      Set.of(
          "confinement of answers",
          "python of answers",
          "inputTokens",
          "outputTokens",
          "attached",
          "faults",
          "margin",
          "value of margin",
          "judges",
          "limits",
          "latency",
          "absent",
          "impact_speed",
          "impact",
          "stopped",
          "minimal_gap",
          "time of detections",
          "ended",
          "period",
          "jitter",
          "executionTime",
          "hostExecutionTime",
          "timesWorstCase",
          "waiting of hops",
          "age",
          "samples",
          "tooOld",
          "late",
          "published of topics",
          "dropped",
          "lost",
          "constraint of latencies",
          "maximum of latencies",
          "bound of latencies",
          "assumes of latencies",
          "aligned of latencies",
          "measured of latencies",
          "period of parts",
          "saved of parts",
          "largest of parts",
          "after of margins",
          "processors",
          "percent of processors",
          "priority",
          "percent of components",
          "response");

  private static final Set<Stage> SAMPLES =
      Set.of(Stage.IMPLEMENT, Stage.VALIDATE, Stage.GENERATE, Stage.SIMULATE);

  @ParameterizedTest
  @EnumSource(names = {"IMPLEMENT", "VALIDATE", "GENERATE", "SIMULATE"})
  void recordIsWrittenAsItWasRead(Stage stage) throws IOException {
    StageRecord record = read(stage, sample(stage));
    assertEquals(
        sample(stage).toString(), new String(ResultJson.bytes(record), StandardCharsets.UTF_8));
    assertEquals(
        sample(stage).get("report").toString(), ResultJson.tree(record.report()).toString());
  }

  @ParameterizedTest
  @EnumSource(names = {"IMPLEMENT", "VALIDATE", "SIMULATE"})
  void onlyOptionalKeysMayBeMissing(Stage stage) throws IOException {
    List<String> wrong = new ArrayList<>();
    forEachKey(
        stage,
        (place, changed) -> {
          place.object().remove(place.key());
          boolean optional =
              OPTIONAL.contains(place.key())
                  || OPTIONAL.contains(place.key() + " of " + place.parent());
          if (isReadable(stage, changed) != optional) {
            wrong.add(place.key() + " of " + place.parent());
          }
        });
    assertEquals(List.of(), wrong);
  }

  @ParameterizedTest
  @EnumSource(names = {"IMPLEMENT", "VALIDATE", "SIMULATE"})
  void misspeltKeyIsRefused(Stage stage) throws IOException {
    List<String> accepted = new ArrayList<>();
    forEachKey(
        stage,
        (place, changed) -> {
          place.object().set(place.key() + "x", place.object().get(place.key()));
          if (isReadable(stage, changed)) {
            accepted.add(place.key());
          }
        });
    assertEquals(List.of(), accepted);
  }

  @ParameterizedTest
  @EnumSource(names = {"IMPLEMENT", "VALIDATE", "SIMULATE"})
  void nullIsNoValue(Stage stage) throws IOException {
    List<String> accepted = new ArrayList<>();
    forEachKey(
        stage,
        (place, changed) -> {
          place.object().putNull(place.key());
          if (isReadable(stage, changed)) {
            accepted.add(place.key());
          }
        });
    // Lists that JSON omits where they are empty.
    assertEquals(
        List.of(),
        accepted.stream().filter(key -> !key.matches("faults|judges|limits|processors")).toList());
  }

  /** A finding about something untested would else count as an error, or could be suppressed. */
  @Test
  void findingsKeepWhatIsKnownOfTheirRules() throws IOException {
    Rule rule = Rule.error("a.b", CommonTrait.UNTESTED, CommonTrait.UNSUPPRESSIBLE);
    assertEquals(rule, ResultJson.read(ResultJson.bytes(rule), Rule.class));
    byte[] other =
        new String(ResultJson.bytes(rule), StandardCharsets.UTF_8)
            .replace("UNTESTED", "OF_CALL")
            .getBytes(StandardCharsets.UTF_8);
    assertThrows(IOException.class, () -> ResultJson.read(other, Rule.class));
  }

  @Test
  void recordOfAnotherStageIsRefused() throws IOException {
    for (Stage of : SAMPLES) {
      for (Stage as : SAMPLES) {
        boolean empty = of == Stage.GENERATE && as == Stage.IMPLEMENT;
        assertEquals(of == as || empty, isReadable(as, sample(of)), of + " as " + as);
      }
    }
  }

  @Test
  void repeatedKeyAndFurtherTextAreRefused() throws IOException {
    String text = sample(Stage.GENERATE).toString();
    assertTrue(isReadable(Stage.GENERATE, text));
    assertFalse(
        isReadable(Stage.GENERATE, text.replace("\"report\":{}", "\"report\":{},\"key\":\"\"")));
    assertFalse(isReadable(Stage.GENERATE, text + "{}"));
  }

  @Test
  void verdictWithoutAVerdictHasFewKeys() throws IOException {
    VerdictFile none = VerdictFile.without("aeb", Optional.of("design"));
    String json = new String(ResultJson.bytes(none), StandardCharsets.UTF_8);
    assertEquals(
        "{\"chain\":\"aeb\",\"passed\":false,\"stoppedIn\":\"design\",\"scenarios\":[]}", json);
    assertEquals(none, ResultJson.read(json.getBytes(StandardCharsets.UTF_8), VerdictFile.class));
    byte[] misspelt = json.replace("passed", "pased").getBytes(StandardCharsets.UTF_8);
    assertThrows(IOException.class, () -> ResultJson.read(misspelt, VerdictFile.class));
  }

  /** Jackson takes it for a value of any type, of which nobody could ask anything. */
  @Test
  void refusesNull() {
    byte[] nothing = "null".getBytes(StandardCharsets.UTF_8);
    assertThrows(IOException.class, () -> ResultJson.read(nothing, VerdictFile.class));
    assertEquals(Optional.empty(), ResultJson.ifValid(nothing, VerdictFile.class));
    assertFalse(isReadable(Stage.GENERATE, "null"));
  }

  private record Place(String parent, ObjectNode object, String key) {}

  /** Calls a change for each key of a fresh copy of a sample's report. */
  private static void forEachKey(Stage stage, BiConsumer<Place, JsonNode> change)
      throws IOException {
    int count = places(sample(stage)).size();
    assertTrue(count >= 7, "there is something to change");
    for (int i = 0; i < count; i++) {
      JsonNode copy = sample(stage);
      change.accept(places(copy).get(i), copy);
    }
  }

  private static List<Place> places(JsonNode sample) {
    String root = sample.at("/report/conversation").isArray() ? "answers" : "report";
    List<Place> places = new ArrayList<>();
    collect(root, sample.get("report"), places);
    return places;
  }

  private static void collect(String parent, JsonNode node, List<Place> places) {
    if (node.isArray()) {
      node.forEach(each -> collect(parent, each, places));
    }
    if (node instanceof ObjectNode object) {
      object
          .properties()
          .forEach(
              each -> {
                places.add(new Place(parent, object, each.getKey()));
                collect(each.getKey(), each.getValue(), places);
              });
    }
  }

  private static boolean isReadable(Stage stage, JsonNode json) {
    return isReadable(stage, json.toString());
  }

  private static boolean isReadable(Stage stage, String json) {
    try {
      ResultJson.read(json.getBytes(StandardCharsets.UTF_8), StageRecord.class, stage);
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  private static StageRecord read(Stage stage, JsonNode json) throws IOException {
    return ResultJson.read(
        json.toString().getBytes(StandardCharsets.UTF_8), StageRecord.class, stage);
  }

  private static JsonNode sample(Stage stage) throws IOException {
    try (InputStream stream = ResultJsonTest.class.getResourceAsStream(stage.id() + ".json")) {
      return MAPPER.readTree(stream);
    }
  }
}
