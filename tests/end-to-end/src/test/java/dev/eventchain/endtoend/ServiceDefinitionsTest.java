package dev.eventchain.endtoend;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that definitions of services reach the runtime as those of messages do. */
class ServiceDefinitionsTest {

  @TempDir private Path folder;

  @Test
  void servicesArePrintedAndTheirMistakesFound() throws IOException {
    Path definition = folder.resolve("demo_srvs/srv/Sum.srv");
    Files.createDirectories(definition.getParent());
    Files.writeString(definition, "int32 a\nint32 b\n---\nint64 sum\n");
    new Program()
        .run("messages", folder)
        .expect(0)
        .says(
            "\"demo_srvs/srv/Sum_Request\": {\"fields\": [[\"a\", \"int32\"], [\"b\", \"int32\"]]")
        .says("\"demo_srvs/srv/Sum_Response\": {\"fields\": [[\"sum\", \"int64\"]]");
    Files.writeString(definition, "int32 a\nint32 b\nint64 sum\n");
    new Program()
        .run("messages", folder)
        .expect(1)
        .says("[message.syntax]")
        .says("hint: A service is a request, a line ---, and a response; each may be empty.");
  }
}
