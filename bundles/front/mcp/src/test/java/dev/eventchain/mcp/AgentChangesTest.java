package dev.eventchain.mcp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests what an agent may change, with a script in the place of the command line. */
class AgentChangesTest extends AgentSession {

  @Test
  void aProposalIsCheckedOnACopyAndMadeByItsName() throws Exception {
    JsonNode proposed =
        client
            .begun()
            .call(
                "propose", Map.of("project", "p", "edits", edits("requirements.md", "One", "Two")))
            .path("structuredContent");
    String diff =
        """
        --- a/requirements.md
        +++ b/requirements.md
        @@ -1,1 +1,1 @@
        -# One
        +# Two
        """;
    assertEquals(diff, proposed.path("diff").asText());
    assertEquals("[\"requirements.md\"]", proposed.path("judges").toString());
    assertEquals("# One\n", Files.readString(folder.resolve("p/requirements.md")));
    Map<String, Object> name = Map.of("proposal", proposed.path("proposal").asText());
    assertEquals("Changed: requirements.md", client.text("apply", name));
    assertEquals("# Two\n", Files.readString(folder.resolve("p/requirements.md")));
    assertTrue(client.text("apply", name).contains("[mcp.change]"));
  }

  @Test
  void aProposalAboutFilesThatHaveChangedIsNotMade() throws Exception {
    JsonNode proposed =
        client.begun().call("propose", Map.of("project", "p", "edits", edits("new.md", "", "Two")));
    Files.writeString(folder.resolve("p/new.md"), "by somebody else");
    String id = proposed.at("/structuredContent/proposal").asText();
    assertTrue(client.text("apply", Map.of("proposal", id)).contains("[mcp.change]"));
    assertEquals("by somebody else", Files.readString(folder.resolve("p/new.md")));
  }

  @Test
  void proposalsThatDifferHaveDifferentNames() throws Exception {
    Files.createDirectories(folder.resolve("q"));
    Files.writeString(folder.resolve("q/eventchain.yaml"), "name: q\n");
    client.begun();
    JsonNode whole = proposed("p", "x.md", "Two\n");
    JsonNode open = proposed("p", "x.md", "Two");
    JsonNode windows = proposed("p", "x.md", "Two\r\n");
    JsonNode empty = proposed("p", "x.md", "");
    JsonNode other = proposed("q", "x.md", "Two\n");
    String head = "--- /dev/null\n+++ b/x.md\n";
    assertEquals(head + "@@ -0,0 +1,1 @@\n+Two\n", whole.path("diff").asText());
    assertEquals(
        head + "@@ -0,0 +1,1 @@\n+Two\n\\ No newline at end of file\n", open.path("diff").asText());
    assertEquals(head + "@@ -0,0 +1,1 @@\n+Two␍\n", windows.path("diff").asText());
    assertEquals(head + "\\ New empty file\n", empty.path("diff").asText());
    assertEquals(
        5,
        Stream.of(whole, open, windows, empty, other)
            .map(each -> each.path("proposal").asText())
            .distinct()
            .count());
    assertTrue(whole.path("checked").asBoolean());
    client.text("apply", Map.of("proposal", whole.path("proposal").asText()));
    assertEquals("Two\n", Files.readString(folder.resolve("p/x.md")));
    assertFalse(Files.exists(folder.resolve("q/x.md")));
  }

  private JsonNode proposed(String project, String file, String text) throws Exception {
    return client
        .call("propose", Map.of("project", project, "edits", edits(file, "", text)))
        .path("structuredContent");
  }

  @Test
  void aProposalWhoseCheckCouldNotBeDoneIsMadeAsUnchecked() throws Exception {
    Files.createDirectories(folder.resolve("unreadable"));
    Files.writeString(folder.resolve("unreadable/eventchain.yaml"), "name: p\n");
    client.begun();
    JsonNode proposed = proposed("unreadable", "x.md", "Two\n");
    assertFalse(proposed.path("checked").asBoolean(true));
    JsonNode applied = client.call("apply", Map.of("proposal", proposed.path("proposal").asText()));
    assertFalse(applied.at("/structuredContent/checked").asBoolean(true));
    assertTrue(applied.at("/content/0/text").asText().contains("Unchecked"), applied.toString());
  }

  @Test
  void measuredTimesAreAProposal() throws Exception {
    Files.writeString(folder.resolve("drive.txt"), "trace");
    Files.writeString(folder.resolve("other.txt"), "trace");
    JsonNode measured =
        client.begun().call("measure", trace("drive.txt")).path("structuredContent");
    assertEquals(0, measured.path("exitCode").asInt(-1));
    assertEquals(0, measured.at("/check/exitCode").asInt(-1));
    assertTrue(measured.path("checked").asBoolean());
    assertTrue(measured.path("diff").asText().endsWith("-# One\n+# Longer\n"), measured.toString());
    assertEquals("# One\n", Files.readString(folder.resolve("p/requirements.md")));
    // The proposal of another trace is none of this one.
    JsonNode other = client.call("measure", trace("other.txt")).path("structuredContent");
    assertFalse(other.has("proposal"), other.toString());
    client.text("apply", Map.of("proposal", measured.path("proposal").asText()));
    assertEquals("# Longer\n", Files.readString(folder.resolve("p/requirements.md")));
    assertTrue(client.text("measure", trace("drive.txt")).contains("[mcp.change]"));
    assertTrue(client.text("measure", trace("../drive.txt")).contains("[mcp.outside]"));
  }

  private static Map<String, Object> trace(String name) {
    return Map.of("project", "p", "trace", name);
  }

  @ParameterizedTest
  @CsvSource({
    "eventchain.yaml, name, mcp.protected",
    "eventchain-suppressions.yaml, '', mcp.protected",
    "mutants.yaml, '', mcp.protected",
    "accepted.yaml, '', mcp.protected",
    "out/verdict.json, '', mcp.protected",
    ".git/config, '', mcp.protected",
    "recordings/x.json, '', mcp.protected",
    "../q/x.md, '', mcp.protected",
    "../../x.md, '', mcp.outside",
    "/etc/passwd, '', mcp.outside",
    "requirements.md, Three, mcp.change",
    "requirements.md, One, mcp.change"
  })
  void whatMayNotOrCannotBeChangedIsRefused(String file, String old, String rule) throws Exception {
    String text =
        client.begun().text("propose", Map.of("project", "p", "edits", edits(file, old, old)));
    assertTrue(text.contains("[" + rule + "]"), text);
  }

  @ParameterizedTest
  @CsvSource({
    "., p/eventchain-suppressions.yaml",
    "., p/accepted.yaml",
    "., p/out/verdict.json",
    "p/recordings, x.json",
    "p/out, verdict.json",
    "p/scenarios, x.yaml",
    "p, scenarios/eventchain.yaml",
    "p, q/requirements.md",
    "p, behind/x.md",
    ".hidden, x.md"
  })
  void noNameOfTheProjectMakesAFileChangeable(String project, String file) throws Exception {
    for (String name : List.of("p/recordings", "p/scenarios", "p/q", ".hidden")) {
      Files.createDirectories(folder.resolve(name));
    }
    Files.writeString(folder.resolve("p/q/eventchain.yaml"), "name: q\n");
    Files.createSymbolicLink(folder.resolve("p/behind"), Path.of("recordings"));
    String text =
        client.begun().text("propose", Map.of("project", project, "edits", edits(file, "", "x")));
    assertTrue(text.contains("[mcp.protected]"), text);
  }

  @ParameterizedTest
  @ValueSource(strings = {"p", "p/out", "p/scenarios", ".", ".vscode", "new/.git", "above", "link"})
  void aTemplateWritesIntoNoProject(String output) throws Exception {
    Files.createDirectories(folder.resolve("above/q"));
    Files.writeString(folder.resolve("above/q/eventchain.yaml"), "name: q\n");
    Files.createSymbolicLink(folder.resolve("link"), Path.of("p"));
    String text = client.begun().text("generate", template(output));
    assertTrue(text.contains("[mcp.protected]"), text);
  }

  @ParameterizedTest
  @ValueSource(strings = {"p/out/text", "new/text"})
  void aTemplateWritesIntoAFolderOfItsOwn(String output) throws Exception {
    String text = client.begun().text("generate", template(output));
    assertFalse(text.contains("[mcp.protected]"), text);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "out",
        "recordings",
        "accepted.yaml",
        "mutants.yaml",
        "eventchain-suppressions.yaml"
      })
  void noProjectStartsAroundWhatWouldDecideAboutIt(String name) throws Exception {
    client.begun();
    Files.createDirectories(folder.resolve("new"));
    assertFalse(client.text("init", Map.of("project", "new")).contains("[mcp.protected]"));
    Files.writeString(folder.resolve("new/" + name), "");
    assertTrue(client.text("init", Map.of("project", "new")).contains("[mcp.protected]"));
  }

  private static Map<String, Object> template(String output) {
    return Map.of("template", "t.mtl", "models", List.of("m.xmi"), "output", output);
  }

  @ParameterizedTest
  @ValueSource(strings = {".git", "p/scenarios", "p/out"})
  void noProjectStartsInAnother(String project) throws Exception {
    String text = client.begun().text("init", Map.of("project", project));
    assertTrue(text.contains("[mcp.protected]"), text);
  }
}
