package dev.eventchain.mcp;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;

/** A session with the server, with a script in the place of the command line. */
abstract class AgentSession {

  static final Path RESOURCES = Path.of("src/test/resources/dev/eventchain/mcp");
  static final Path SCRIPT = RESOURCES.resolve("program.sh");

  @TempDir Path folder;

  Client client;

  @BeforeEach
  void start() throws Exception {
    Files.createDirectories(folder.resolve("p"));
    Files.writeString(folder.resolve("p/eventchain.yaml"), "name: p\n");
    Files.writeString(folder.resolve("p/requirements.md"), "# One\n");
    client = new Client(folder, SCRIPT);
  }

  @AfterEach
  void end() throws Exception {
    client.end();
  }

  static Map<String, Object> project() {
    return Map.of("project", "p");
  }

  static List<Map<String, String>> edits(String file, String old, String text) {
    return List.of(Map.of("file", file, "old", old, "new", text));
  }
}
