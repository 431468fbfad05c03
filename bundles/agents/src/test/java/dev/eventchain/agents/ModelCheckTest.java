package dev.eventchain.agents;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.description.EventChainReader;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.project.Requirements;
import dev.eventchain.project.SoftwareBase;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Instance models of a departure warning with one fault each, and the findings about them. */
class ModelCheckTest {
  private static final Path RESOURCES = Path.of("src/test/resources");

  private static EventChain direct;

  @BeforeAll
  static void chain(@TempDir Path folder) throws IOException {
    Files.writeString(
        folder.resolve("components.json"),
        """
        [{"name": "Lane_Detection", "file": "components.json"},
         {"name": "Driver_Warning", "implementation": "node"}]
        """);
    Requirements requirements = Requirements.read(example("requirements.md"));
    direct =
        EventChainReader.read(
                example("chain.json"),
                "lane_departure_warning",
                requirements.items(),
                OptionalDouble.empty())
            .root();
    SoftwareBase.read(folder).markExisting(direct);
  }

  @Test
  void theExampleItselfIsFine() {
    assertEquals(List.of(), ModelAgent.check(ModelAgent.read(example("instance.json")), direct));
  }

  @ParameterizedTest
  @MethodSource
  void eachFaultIsFoundWhereItIs(Path file) throws IOException {
    List<Diagnostic> found =
        ModelAgent.check(ModelAgent.read(SourceText.read(file)), direct).stream().sorted().toList();
    FindingLines.check(file, found);
  }

  static List<Path> eachFaultIsFoundWhereItIs() throws IOException {
    return ExpectedFile.inputs(RESOURCES.resolve("model"), ".json");
  }

  private static SourceText example(String part) {
    return SourceText.read(RESOURCES.resolve("departure-warning").resolve(part));
  }
}
