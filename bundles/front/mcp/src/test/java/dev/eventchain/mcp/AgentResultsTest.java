package dev.eventchain.mcp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/** Tests what an agent reads of results, with a script in the place of the command line. */
class AgentResultsTest extends AgentSession {

  @Test
  void resultsAreAsTheSchemasSay() throws Exception {
    Files.createDirectories(folder.resolve("p/out/curves"));
    Files.copy(RESOURCES.resolve("verdict.json"), folder.resolve("p/out/verdict.json"));
    Files.copy(RESOURCES.resolve("curves.csv"), folder.resolve("p/out/curves/s.csv"));
    Map<String, JsonNode> schemas = new TreeMap<>();
    client
        .begun()
        .request("tools/list", Map.of())
        .at("/result/tools")
        .forEach(tool -> schemas.put(tool.path("name").asText(), tool.path("outputSchema")));
    Map<String, Map<String, Object>> calls =
        Map.of(
            "validate", project(),
            "init", project(),
            "explain", Map.of(),
            "results", project(),
            "query", Map.of("project", "p", "table", "criteria"),
            "signals", Map.of("project", "p", "scenario", "s", "time", 1),
            "propose", Map.of("project", "p", "edits", edits("requirements.md", "One", "Two")));
    for (Map.Entry<String, Map<String, Object>> call : calls.entrySet()) {
      JsonNode result = client.call(call.getKey(), call.getValue());
      assertFalse(result.path("isError").asBoolean(), result.toString());
      JsonNode schema = schemas.get(call.getKey());
      assertEquals(
          List.of(),
          List.copyOf(
              JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012)
                  .getSchema(schema)
                  .validate(result.path("structuredContent"))),
          call.getKey());
      for (String name : required(result)) {
        assertTrue(schema.path("properties").has(name), call.getKey() + " " + name);
      }
    }
  }

  private static List<String> required(JsonNode result) {
    List<String> names = new ArrayList<>();
    result.path("structuredContent").fieldNames().forEachRemaining(names::add);
    return names;
  }

  @Test
  void tablesAreReadByThePage() throws Exception {
    Files.createDirectories(folder.resolve("p/out/curves"));
    Files.copy(RESOURCES.resolve("verdict.json"), folder.resolve("p/out/verdict.json"));
    Files.copy(RESOURCES.resolve("curves.csv"), folder.resolve("p/out/curves/s.csv"));
    client.begun();
    JsonNode failed =
        query(
            "criteria",
            Map.of(
                "where",
                List.of(Map.of("column", "passed", "equals", false)),
                "columns",
                List.of("text")));
    assertEquals("[{\"text\":\"it stops\"}]", failed.path("rows").toString());
    JsonNode first =
        query("criteria", Map.of("orderBy", "margin.value", "descending", true, "limit", 1));
    assertEquals("no impact", first.at("/rows/0/text").asText());
    assertEquals(1, first.path("next").asInt());
    JsonNode fast =
        query("curves/s", Map.of("where", List.of(Map.of("column", "speed [m/s]", "least", 9.5))));
    assertEquals(2, fast.path("total").asInt());
    JsonNode around =
        client
            .call("signals", Map.of("project", "p", "scenario", "s", "time", 1.0, "around", 0.1))
            .path("structuredContent");
    assertEquals(
        "[{\"time [s]\":1,\"gap [m]\":5.5,\"speed, \\\"true\\\"\":10}]",
        around.path("rows").toString().replace("\"speed [m/s]\":9,", ""));
  }

  private JsonNode query(String table, Map<String, Object> more) throws Exception {
    Map<String, Object> arguments = new TreeMap<>(more);
    arguments.putAll(Map.of("project", "p", "table", table));
    return client.call("query", arguments).path("structuredContent");
  }

  @Test
  void resultsOfAnOlderProjectSaySo() throws Exception {
    Files.createDirectories(folder.resolve("p/out"));
    Files.copy(RESOURCES.resolve("verdict.json"), folder.resolve("p/out/verdict.json"));
    assertEquals(
        "[]",
        client.begun().call("results", project()).at("/structuredContent/changedSince").toString());
    Path file = folder.resolve("p/requirements.md");
    Files.setLastModifiedTime(
        file,
        java.nio.file.attribute.FileTime.fromMillis(
            Files.getLastModifiedTime(file).toMillis() + 60_000));
    String text = client.text("results", project());
    assertTrue(text.startsWith("Changed after these results: requirements.md"), text);
  }
}
