package dev.eventchain.documentation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.documentation.examples.ModelFromJson;
import dev.eventchain.documentation.examples.RunSimulation;
import dev.eventchain.documentation.examples.RunTemplate;
import dev.eventchain.documentation.examples.ValidateModel;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.pipeline.run.RunResult;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the classes on the page about the Java API. */
class JavaExamplesTest {

  private static final Path DATA = Path.of("src", "test", "resources");
  private static final Path METAMODEL = DATA.resolve("library.ecore");

  @TempDir Path folder;

  private Path model() throws IOException {
    Path model = folder.resolve("model.xmi");
    assertEquals(List.of(), ModelFromJson.convert(METAMODEL, DATA.resolve("library.json"), model));
    return model;
  }

  @Test
  void jsonBecomesAModel() throws IOException {
    assertEquals(2, Files.readString(model()).lines().filter(l -> l.contains("<books")).count());
  }

  @Test
  void jsonThatIsNoModelIsNotWritten() throws IOException {
    Path json = Files.writeString(folder.resolve("bad.json"), "{\"eClass\": \"Shelf\"}");
    Path model = folder.resolve("bad.xmi");
    List<Diagnostic> found = ModelFromJson.convert(METAMODEL, json, model);
    assertEquals(List.of("modeler.class.unknown"), found.stream().map(Diagnostic::id).toList());
    assertFalse(Files.exists(model));
  }

  @Test
  void aModelIsValidated() throws IOException {
    List<Diagnostic> found =
        ValidateModel.validate(METAMODEL, DATA.resolve("library.ocl"), model());
    assertEquals(List.of("Book::HasPages"), found.stream().map(Diagnostic::rule).toList());
  }

  @Test
  void aTemplateWritesFiles() throws IOException {
    Path out = folder.resolve("out");
    assertEquals(
        List.of(), RunTemplate.generate(METAMODEL, DATA.resolve("library.mtl"), model(), out));
    assertEquals("Emma, 474 pages\n", Files.readString(out.resolve("Emma.txt")));
  }

  @Test
  void aProjectIsTakenToItsVerdict() throws IOException {
    RunResult result = RunSimulation.run(project(), folder.resolve("out"));
    assertEquals(RunResult.Verdict.PASSED, result.verdict(), result.diagnostics()::toString);
  }

  /** Returns a copy of an example without the strength of its requirements, which takes longest. */
  private Path project() throws IOException {
    Path example = Path.of("../../examples/radar-aeb");
    Path project = folder.resolve("project");
    return Projects.withoutStrength(Projects.copy(example, project));
  }
}
