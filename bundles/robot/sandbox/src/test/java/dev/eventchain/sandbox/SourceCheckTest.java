package dev.eventchain.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.sandbox.SourceCheck.Source;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Each file {@code sources/RULE/NAME.py} is checked as the source of an existing component against
 * {@code NAME.expected} beside it; {@code good} files must have no findings.
 */
class SourceCheckTest {

  private static final Path FIXTURES = Path.of("src/test/resources/sources");
  private static final ComponentSignature SIGNATURE =
      new ComponentSignature("TTC", List.of("distance", "speed"), List.of("ttc"));
  private static final SourceCheck CHECK = new SourceCheck(TestEnvironment.PYTHON);

  private static final Path NODES = Path.of("src/test/resources/nodes");

  static List<Path> sources() throws IOException {
    return pythonFiles(FIXTURES);
  }

  static List<Path> nodes() throws IOException {
    return pythonFiles(NODES);
  }

  private static List<Path> pythonFiles(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      return files.filter(file -> file.toString().endsWith(".py")).sorted().toList();
    }
  }

  @ParameterizedTest
  @MethodSource("sources")
  void findingsAreAsExpected(Path file) throws IOException {
    String actual = DiagnosticFormat.TEXT.render(CHECK.check(List.of(component(file))));
    if (file.getFileName().toString().startsWith("good")) {
      assertEquals("", actual);
    } else {
      ExpectedFile.check(ExpectedFile.beside(file), actual);
    }
  }

  /**
   * Warnings are uses that the node {@code Brake} may never come to, and arguments without which it
   * runs; a file of JSON beside it has what its description gives it.
   */
  @ParameterizedTest
  @MethodSource("nodes")
  void nodesAreCheckedForRepeatabilityAndArguments(Path file) throws IOException {
    String name = file.getFileName().toString();
    SourceText text = SourceText.read(file);
    Source source =
        name.startsWith("module")
            ? Source.besideNode(text)
            : Source.ofNode(text, "Brake", given(file));
    String actual = DiagnosticFormat.TEXT.render(CHECK.check(List.of(source)));
    if (name.startsWith("good")) {
      assertEquals("", actual);
    } else {
      ExpectedFile.check(ExpectedFile.beside(file), actual);
    }
  }

  private static Optional<JsonNode> given(Path node) throws IOException {
    Path arguments = node.resolveSibling(node.getFileName().toString().replace(".py", ".json"));
    return Files.exists(arguments)
        ? Optional.of(new ObjectMapper().readTree(arguments.toFile()))
        : Optional.empty();
  }

  @Test
  void aHelperIsCheckedForRepeatabilityOnly() {
    Path clock = FIXTURES.resolve("component.clock/bad.py");
    Path spelling = FIXTURES.resolve("component.class.missing/bad_spelling.py");
    List<Diagnostic> found =
        CHECK.check(
            List.of(
                Source.of(SourceText.read(spelling), Optional.empty()),
                Source.of(SourceText.read(clock), Optional.empty())));
    assertEquals(
        List.of("component.clock"), found.stream().map(Diagnostic::id).distinct().toList());
    assertEquals(clock.toString(), found.get(0).location().file());
  }

  @Test
  void findingsOfSeveralFilesAreInTheirOrder() {
    List<Diagnostic> found =
        CHECK.check(
            List.of(
                component(FIXTURES.resolve("component.thread/bad.py")),
                component(FIXTURES.resolve("component.syntax/bad.py"))));
    assertEquals(
        List.of("component.thread", "component.thread", "component.syntax"),
        found.stream().map(Diagnostic::id).toList());
  }

  @Test
  void sourceThatPythonCannotReadIsAFinding() {
    String deep = "x = " + "(".repeat(5000) + ")".repeat(5000);
    List<Diagnostic> found =
        CHECK.check(
            List.of(Source.of(SourceText.of("component.py", deep), Optional.of(SIGNATURE))));
    assertEquals(List.of("component.syntax"), found.stream().map(Diagnostic::id).toList());
  }

  private static Source component(Path file) {
    return Source.of(SourceText.read(file), Optional.of(SIGNATURE));
  }
}
