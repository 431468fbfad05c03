package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Tests that a defect of the program names the input file. The program is broken on purpose for it.
 */
class DefectTest {

  private static final String TEMPLATE =
      """
      [module main('http://example.org/library')]
      [template public main(library : Library)]
      [comment @main /]
      [file ('x', false)]x[/file]
      [/template]
      """;

  @TempDir Path folder;

  @BeforeEach
  void write() throws IOException {
    Files.writeString(folder.resolve("library.ecore"), AnyMetamodelTest.ECORE);
    Files.writeString(folder.resolve("model.xmi"), AnyMetamodelTest.MODEL);
    Files.writeString(folder.resolve("rules.ocl"), "context Book\ninv A: self.pages > 0\n");
    Files.writeString(folder.resolve("main.mtl"), TEMPLATE);
    Files.writeString(folder.resolve("decided.yaml"), "[]\n");
  }

  static Stream<Arguments> files() {
    return Thorough.allOrOne(
        List.of(
            arguments("xmi.MetamodelChecks", "library.ecore:"),
            arguments("constraints.document.RuleDocument", "rules.ocl:"),
            arguments("constraints.RuleComments", "rules.ocl:2:1:"),
            arguments("documents.YamlTree", "decided.yaml:")))
        .stream();
  }

  @ParameterizedTest
  @MethodSource("files")
  void ofAValidationNamesTheFile(String broken, String place) throws IOException {
    breaking(broken)
        .run(
            "validate",
            "--metamodel",
            folder.resolve("library.ecore"),
            "--ocl",
            folder.resolve("rules.ocl"),
            "--suppressions",
            folder.resolve("decided.yaml"),
            folder.resolve("model.xmi"))
        .expect(3)
        .says(folder.resolve(place) + " error: This is a defect in eventchain: ")
        .says("[eventchain.defect]");
  }

  @Test
  void ofAValidationNamesTheModel() throws IOException {
    Path chain =
        Files.writeString(
            folder.resolve("chain.xmi"),
            "<e:EventChain xmlns:e='http://eventchain.dev/eventchain/1.0' name='a'/>");
    breaking("xmi.EcorePlan")
        .run("validate", chain)
        .expect(3)
        .says(chain + ": error: This is a defect in eventchain: ");
  }

  @Test
  void ofAGenerationNamesTheTemplate() throws IOException {
    breaking("m2t.syntax.BlockParser")
        .run(
            "generate",
            "--metamodel",
            folder.resolve("library.ecore"),
            "--template",
            folder.resolve("main.mtl"),
            folder.resolve("model.xmi"),
            "-o",
            folder.resolve("out"))
        .expect(3)
        .says(folder.resolve("main.mtl") + ": error: This is a defect in eventchain: ");
  }

  /** Returns the program with an empty class in place of one of its own. */
  private Program breaking(String name) throws IOException {
    int dot = name.lastIndexOf('.');
    String text =
        "package dev.eventchain." + name.substring(0, dot) + ";\nclass " + name.substring(dot + 1);
    Path source =
        Files.writeString(folder.resolve(name.substring(dot + 1) + ".java"), text + " {}");
    Path classes = Files.createDirectories(folder.resolve("classes"));
    int failed =
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, null, "-d", classes.toString(), source.toString());
    assertEquals(0, failed);
    return new Program().with("JAVA_TOOL_OPTIONS", "-Xbootclasspath/a:" + classes);
  }
}
