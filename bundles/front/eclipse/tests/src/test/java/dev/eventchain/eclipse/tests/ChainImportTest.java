package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.eclipse.ChainImport;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that a JSON description becomes a model, or a finding with its line. */
class ChainImportTest {

  static final String DESCRIPTION =
      """
      [
        {
          "name": "Tracking",
          "description": "Tracks.",
          "input": [
            {"topic": "/scan", "message_type": "sensor_msgs/msg/LaserScan",
             "qos_profile": {"reliability": "reliable"},
             "values": [{"name": "ranges", "field": "ranges", "description": "Ranges."}]}
          ],
          "output": []
        }
      ]
      """;

  @TempDir Path folder;

  private ChainImport read(String description) throws Exception {
    Path file = folder.resolve("chain.json");
    Files.writeString(file, description);
    return ChainImport.read(
        file, "tracking", folder.resolve("requirements.md"), OptionalDouble.of(20));
  }

  @Test
  void descriptionBecomesAModel() throws Exception {
    String model = new String(read(DESCRIPTION).model(), StandardCharsets.UTF_8);
    assertTrue(model.contains("name=\"tracking\""), model);
    assertTrue(model.contains("frequency=\"20.0\""), model);
    assertTrue(model.contains("topicName=\"/scan\""), model);
  }

  @Test
  void errorsHaveTheirLine() {
    DiagnosticException failure =
        assertThrows(
            DiagnosticException.class,
            () -> read(DESCRIPTION.replace("\"topic\": \"/scan\"", "\"topic\": 5")));
    assertEquals(6, failure.diagnostics().get(0).location().line());
  }
}
