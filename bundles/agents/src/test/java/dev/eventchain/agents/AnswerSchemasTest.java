package dev.eventchain.agents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.llm.ChatModels;
import dev.eventchain.llm.chat.AnswerSchema;
import dev.eventchain.llm.chat.ChatModel;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The schemas of the tasks that answer in JSON. */
class AnswerSchemasTest {
  private static final JsonMapper MAPPER = new JsonMapper();
  private static final Path EXPECTED = Path.of("src/test/resources/schemas");

  static List<ExampleWorkflow> examples() {
    return ExampleRecordingsTest.examples();
  }

  /** Returns the schema of each task that has one. */
  private static Map<String, AnswerSchema> schemas(ExampleWorkflow example) {
    Map<String, AnswerSchema> schemas = new LinkedHashMap<>();
    ChatModel replay =
        ChatModels.open("replay", ExampleWorkflow.MODEL, example.recordings(), false);
    example.run(
        request -> {
          request.schema().ifPresent(schema -> schemas.put(request.task(), schema));
          return replay.chat(request);
        });
    return schemas;
  }

  @ParameterizedTest
  @MethodSource("examples")
  void theSchemasAreAsExpectedAndKeepToTheLimits(ExampleWorkflow example) throws IOException {
    Map<String, AnswerSchema> schemas = schemas(example);
    assertEquals(TASKS, schemas.keySet());
    for (Map.Entry<String, AnswerSchema> each : schemas.entrySet()) {
      String name = example.folder() + "." + each.getKey();
      AnswerSchema schema = each.getValue();
      ExpectedFile.check(EXPECTED.resolve(name + ".nested.json"), text(schema.nested()));
      ExpectedFile.check(EXPECTED.resolve(name + ".flat.json"), text(schema.flat()));
      assertEquals(List.of(), ProviderLimits.openAi(schema.nested()), name);
      assertEquals(List.of(), ProviderLimits.anthropic(schema.flat()), name);
      assertEquals(List.of(), ProviderLimits.gemini(schema.flat()), name);
    }
  }

  private static String text(JsonNode schema) {
    return schema.toPrettyString().replace("\r\n", "\n") + "\n";
  }

  /** The schema in a recording is the one that was sent. */
  @ParameterizedTest
  @MethodSource("examples")
  void theAuthoredAnswersSatisfyTheSchemasThatTheyWereAskedWith(ExampleWorkflow example)
      throws IOException {
    for (String task : TASKS) {
      List<Path> recordings = files(example.recordings().resolve(task));
      assertEquals(1, recordings.size(), task);
      JsonNode recording = MAPPER.readTree(recordings.get(0).toFile());
      JsonNode schema = recording.at("/request/schema");
      assertTrue(schema.isObject(), task);
      List<String> lines = new ArrayList<>();
      recording.at("/samples/0/text").forEach(line -> lines.add(line.asText()));
      String answer = String.join("\n", lines).replaceAll("(?s)^.*```json\n|```\\s*$", "");
      assertEquals(Set.of(), validate(schema, MAPPER.readTree(answer)), task);
    }
  }

  private static List<Path> files(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.sorted().toList();
    }
  }

  static Set<?> validate(JsonNode schema, JsonNode answer) {
    return JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012)
        .getSchema(schema)
        .validate(answer);
  }

  private static final Set<String> TASKS = Set.of("design", "model");
}
