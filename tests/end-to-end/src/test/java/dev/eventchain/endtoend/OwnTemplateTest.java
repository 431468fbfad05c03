package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that the output of a project's own templates is simulated according to its manifest. */
class OwnTemplateTest {

  private static final String NAMES = "templates/python/names.mtl";

  @TempDir static Path folder;

  private static Path project;

  @BeforeAll
  static void design() throws IOException {
    project = Program.exampleIn(folder);
    for (String stage : List.of("design", "implement", "model", "constrain")) {
      new Program().run(stage, project).expect(0);
    }
    for (String set : List.of("ros2-python", "python")) {
      Path copy = Files.createDirectories(project.resolve("templates").resolve(set));
      try (Stream<Path> files = Files.list(Program.ROOT.resolve("templates").resolve(set))) {
        for (Path file : files.toList()) {
          Files.copy(file, copy.resolve(file.getFileName()));
        }
      }
    }
  }

  @Test
  void nobodyButTheTemplatesKnowsWhatTheyCallThings() throws IOException {
    use("templates/ros2-python/main.mtl");
    change("node.rosName().concat('_node')", "node.rosName().concat('_module')");
    change("name.identifier().concat('_node')", "name.identifier().concat('Node')");
    change(".concat('.components.')", ".concat('.parts.')");
    change("'chain'.concat(name) endif", "name endif.concat('_x')");
    new Program().run("generate", project).expect(0).says("files in ros2/aeb_x");
    assertTrue(Files.exists(project.resolve("out/ros2/aeb_x/aeb_x/parts/TTC_Calculation.py")));
    assertFalse(Files.exists(project.resolve("out/ros2/aeb")));
    new Program()
        .run("simulate", project, "--scenario", "stopped-vehicle-50")
        .expect(0)
        .says("1 of 1 scenarios passed");
  }

  private static void change(String right, String wrong) throws IOException {
    String text = Files.readString(project.resolve(NAMES));
    assertTrue(text.contains(right), right);
    Files.writeString(project.resolve(NAMES), text.replace(right, wrong));
  }

  @Test
  void whatATemplateOfAProjectPrintsIsMissed() throws IOException {
    Files.writeString(
        project.resolve("printing.mtl"),
        """
        [module printing('http://eventchain.dev/eventchain/1.0')]
        [template public main(chain : EventChain)]
        [comment @main /]
        [for (node : SoftwareNode | chain.software)]
        [file ('stdout', false)][node.name/][/file]
        [/for]
        [file ('x', false)]x[/file]
        [/template]
        """);
    use("printing.mtl");
    Program.Ended ended = new Program().run("generate", project).expect(0);
    String text = ended.says("[project.template.printed]").out();
    assertTrue(
        text.contains("printing.mtl:5:8: warning: The text that this block prints is lost"), text);
    assertEquals(text.indexOf("template.printed"), text.lastIndexOf("template.printed"), text);
  }

  @Test
  void withoutAManifestThereIsNothingToSimulate() throws IOException {
    Files.writeString(
        project.resolve("mine.mtl"),
        """
        [module main('http://eventchain.dev/eventchain/1.0')]
        [template public main(chain : EventChain)]
        [comment @main /]
        [file ('aeb/aeb/components/__init__.py', false, 'UTF-8')]
        # [chain.name/]
        [/file]
        [/template]
        """);
    use("mine.mtl");
    Path simulated = project.resolve("out/verdict.json");
    new Program().run("generate", project).expect(0).says("files in ros2/aeb");
    assertTrue(Files.exists(project.resolve("out/ros2/aeb/aeb/components/TTC_Calculation.py")));
    new Program()
        .run("simulate", project)
        .expect(2)
        .says("[simulation.manifest]")
        .says("mine.mtl: error: The template writes no eventchain-manifest.json")
        .says("Import python::manifest");
    new Program().run("run", project).expect(2).says("[simulation.manifest]");
    assertTrue(Files.readString(simulated).contains("\"passed\" : false,"));
  }

  /** The template of the README; a module next to it replaces a shipped one. */
  @InTurn
  @Test
  void aTemplateThatImportsAShippedSetRunsFromStartToVerdict() throws IOException {
    Path own = Program.exampleIn(folder.resolve("importing"));
    Files.writeString(
        own.resolve("main.mtl"),
        """
        [module main('http://eventchain.dev/eventchain/1.0')]
        [import python::names /]
        [import ros2_python::main /]

        [template public mine(chain : EventChain)]
        [comment @main /]
        [chain.main()/]
        [file (chain.packageName().concat('/NODES.md'), false, 'UTF-8')]
        [for (node : SoftwareNode | chain.wrappedNodes())]
        - [node.nodeClass()/]
        [/for]
        [/file]
        [/template]
        """);
    use(own, "main.mtl");
    new Program().run("run", own).expect(0).says("PASSED: 2 of 2 scenarios passed");
    Path made = own.resolve("out/ros2/aeb");
    assertTrue(Files.readString(made.resolve("NODES.md")).contains("- TTC_Calculation_node\n"));
    assertTrue(Files.exists(made.resolve("launch/aeb.launch.py")));
    Files.writeString(
        own.resolve("launch.mtl"),
        """
        [module launch('http://eventchain.dev/eventchain/1.0')]
        [template public launchFiles(chain : EventChain)]
        [file ('aeb/launch/mine.launch.py', false, 'UTF-8')]
        # [chain.name/]
        [/file]
        [/template]
        """);
    new Program().run("run", own).expect(0).says("PASSED: 2 of 2 scenarios passed");
    assertTrue(Files.exists(made.resolve("launch/mine.launch.py")), "the template has changed");
    assertFalse(Files.exists(made.resolve("launch/aeb.launch.py")));
  }

  /** Also if a set has a module of that name. */
  @Test
  void aSetThatIsNotThereIsNotReplacedByAnother() throws IOException {
    Path own = Files.createDirectories(folder.resolve("wrong"));
    new Program().run("init", own).expect(0);
    use(own, "mine.mtl");
    new Program()
        .run("run", own)
        .expect(2)
        .says("eventchain.yaml:1:11: error: There is no template set and no file 'mine.mtl'.")
        .says("Use cyclonedds-python or ros2-python, or name a *.mtl file of the project.");
    Files.writeString(
        own.resolve("mine.mtl"),
        """
        [module mine('http://eventchain.dev/eventchain/1.0')]
        [import ros3_python::main /]
        [template public mine(chain : EventChain)]
        [comment @main /]
        [chain.main()/]
        [/template]
        """);
    new Program().run("run", own).expect(2).says("[m2t.module.missing]").says("mine.mtl:2:9");
  }

  private static void use(String template) throws IOException {
    use(project, template);
  }

  private static void use(Path project, String template) throws IOException {
    Path configuration = project.resolve("eventchain.yaml");
    String text = Files.readString(configuration).replaceAll("(?m)^template: .*\n", "");
    Files.writeString(configuration, "template: " + template + "\n" + text);
  }
}
