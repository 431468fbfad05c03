package dev.eventchain.endtoend;

import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The radar example, whose signals are those of a network that an AUTOSAR description in two files
 * has.
 */
class ArxmlTest {

  private static final Path NETWORK = Path.of("tests/end-to-end/src/test/resources/arxml");

  @TempDir private Path folder;
  private ProjectCopy project;

  @BeforeEach
  void useTheNetwork() throws IOException {
    project = ProjectCopy.of("radar-aeb", folder);
    try (Stream<Path> files = Files.walk(NETWORK)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        project.write(NETWORK.relativize(file).toString(), Files.readString(file));
      }
    }
  }

  @InTurn
  @Test
  void signalsOfTheNetworkTakeTheChainToPassed() {
    project.run().expect(0).says("PASSED: 2 of 2 scenarios passed, 4 requirements proved");
  }

  @InTurn
  @Test
  void requestBeyondTheLimitsOfTheNetworkIsNotPassed() throws IOException {
    project.replace("types.arxml", ">-10<", ">-8<");
    project.run().expect(1).says("INCOMPLETE").says("[simulation.output.range]");
    project.requireNotPassed();
  }

  @InTurn
  @Test
  void limitThatTheSignalDoesNotKeepFails() throws IOException {
    project.replace("scenarios/stopped-vehicle-50.yaml", "<= -8.9 m/s2", "<= -9.5 m/s2");
    project.run().expect(1).says("FAILED");
    project.requireNotPassed();
  }
}
