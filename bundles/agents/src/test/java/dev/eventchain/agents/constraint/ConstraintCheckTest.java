package dev.eventchain.agents.constraint;

import dev.eventchain.agents.FindingLines;
import dev.eventchain.description.EventChainReader;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.project.Requirements;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * OCL documents and the findings about them: syntax errors, rules without a constraint, trivial
 * constraints.
 */
class ConstraintCheckTest {
  private static final Path RESOURCES = Path.of("src/test/resources");

  @ParameterizedTest
  @MethodSource
  void aConstraintMustSaySomething(Path file) throws IOException {
    ConstraintCheck check =
        new ConstraintCheck(
            List.of("DR-1", "DR-2"), List.of(EventchainPackage.eINSTANCE), List.of(chain()));
    FindingLines.check(file, check.check(SourceText.read(file)));
  }

  static List<Path> aConstraintMustSaySomething() throws IOException {
    return ExpectedFile.inputs(RESOURCES.resolve("constrain"), ".ocl");
  }

  private static EventChain chain() {
    Requirements requirements =
        Requirements.read(SourceText.read(RESOURCES.resolve("departure-warning/requirements.md")));
    SourceText text = SourceText.read(RESOURCES.resolve("departure-warning/chain.json"));
    return EventChainReader.read(text, "example", requirements.items(), OptionalDouble.empty())
        .root();
  }
}
