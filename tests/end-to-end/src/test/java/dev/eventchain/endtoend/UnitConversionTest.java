package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The radar example with components in m/s and both speeds in km/h in messages: what the radar
 * sends, and what one component writes and another one reads.
 */
class UnitConversionTest {

  private static final String CHAIN = "model/chain.xmi";
  private static final String COMPONENTS = "software-base/components.json";
  private static final String SIGNALS = "software-base/signals.json";
  private static final String TRACKING = "software-base/components/Radar_Tracking.py";
  private static final String SCENARIO = "stopped-vehicle-50";

  @TempDir private Path folder;
  private ProjectCopy project;

  @BeforeEach
  void convert() throws IOException {
    project = ProjectCopy.of("radar-aeb", folder.resolve("converted"));
    withoutStrength(project);
    replaceAll(CHAIN, "unit=\"(km/h|m/s)\"", "unit=\"km/h\" componentUnit=\"m/s\"");
    replaceAll(
        COMPONENTS, "\"unit\": \"(km/h|m/s)\"", "\"unit\": \"km/h\", \"component_unit\": \"m/s\"");
    replaceAll(SIGNALS, "\"Unit\": \"m/s\"", "\"Unit\": \"km/h\"");
    project.replace(TRACKING, "-distance_rate / 3.6", "-distance_rate");
    project.write(
        "tests/Radar_Tracking.yaml",
        """
        tests:
        - name: a vehicle that comes nearer
          requirement: RAD-1
          inputs: {valid: true, distance: 50, distance_rate: -10}
          outputs: {ttc: {value: 5, tolerance: 0.001}, closing_speed: {value: 10, tolerance: 0.001}}
        """);
  }

  private void replaceAll(String file, String text, String by) throws IOException {
    Path path = project.path().resolve(file);
    String content = Files.readString(path);
    String changed = content.replaceAll(text, by);
    assertTrue(!changed.equals(content), file);
    Files.writeString(path, changed);
  }

  /** The component converted the radar's speed by itself before; now the node does, as exactly. */
  @Test
  void nothingChangesButWhoConverts() throws IOException {
    project.run().expect(0).says("PASSED: 2 of 2 scenarios passed");
    String node = Files.readString(generated("radar_tracking_node.py"));
    assertTrue(node.contains("= message.range_rate / 3.6  # m/s\n"), node);
    assertTrue(node.contains("= float(output[\"closing_speed\"] * 3.6)  # km/h\n"), node);
    assertTrue(
        Files.readString(generated("brake_request_node.py"))
            .contains("= message.closing_speed / 3.6  # m/s\n"));
    ProjectCopy other = ProjectCopy.of("radar-aeb", folder.resolve("original"));
    withoutStrength(other);
    other.run().expect(0);
    Path original = other.path();
    assertArrayEquals(
        Files.readAllBytes(original.resolve("out/verdict.json")),
        Files.readAllBytes(project.path().resolve("out/verdict.json")));
    String report = Files.readString(project.path().resolve("out/report.html"));
    assertTrue(report.contains("(km/h, m/s within)"));
    assertEquals(50.0, largestClosingSpeed(project.path()), 0.1);
    assertEquals(50.0 / 3.6, largestClosingSpeed(original), 0.1);
  }

  /** Strength takes most of the time, and is about scenarios. */
  private static void withoutStrength(ProjectCopy of) throws IOException {
    of.write("eventchain.yaml", "name: radar_aeb\nfrequency: 50\nstrength: off\n");
  }

  private Path generated(String file) {
    return project.path().resolve("out/ros2/radar_aeb/radar_aeb").resolve(file);
  }

  /** Returns what messages had, which is what recordings and curves show. */
  private static double largestClosingSpeed(Path of) throws IOException {
    List<String> lines = Files.readAllLines(of.resolve("out/curves/" + SCENARIO + ".csv"));
    String[] names = lines.get(0).split(",", -1);
    double largest = 0;
    for (int column = 0; column < names.length; column++) {
      for (int i = 1; names[column].contains("closing_speed") && i < lines.size(); i++) {
        String value = lines.get(i).split(",", -1)[column];
        largest = value.isEmpty() ? largest : Math.max(largest, Double.parseDouble(value));
      }
    }
    return largest;
  }

  @InTurn
  @Test
  void nodesConvertOnCycloneDds() throws IOException {
    new Program().run("generate", project.path()).expect(0);
    new Program()
        .run("simulate", project.path(), "--driver", "dds", "--scenario", SCENARIO)
        .expect(0)
        .says("1 of 1 scenarios passed");
  }

  /** Without the component's unit, 50 km/h would arrive as 50 m/s: the verdict shows it. */
  @Test
  void whatIsNotConvertedDoesNotPass() throws IOException {
    replaceAll(CHAIN, " componentUnit=\"m/s\"", "");
    new Program()
        .run("validate", project.path())
        .expect(1)
        .says("The component unit of the input 'distance_rate' of the existing component")
        .says("is 'm/s', not 'km/h'. [modeler.component.value.changed]");
    replaceAll(COMPONENTS, ", \"component_unit\": \"m/s\"", "");
    project.run().expect(1);
    project.requireNotPassed();
  }

  /** Templates of a project from before units were converted: its nodes, then all of them. */
  @Test
  void whatTemplatesDoNotConvertIsNotGenerated() throws IOException {
    project.write(
        "templates/main.mtl",
        """
        [module main('http://eventchain.dev/eventchain/1.0')]
        [import ros2_python::main /]
        [template public mine(chain : EventChain)]
        [comment @main /]
        [chain.main()/]
        [/template]
        """);
    project.write(
        "templates/node.mtl",
        """
        [module node('http://eventchain.dev/eventchain/1.0')]
        [import python::names /]
        [import python::python /]
        [template public nodeModule(chain : EventChain, node : SoftwareNode)]
        class [node.nodeClass()/]:
            [for (data : Data | node.inputs())]
            def on_[data.keyword()/](self, message):
                self.received[ '[' /][data.keyword().literal()/][ ']' /] = message[data.fieldPath()/]
            [/for]
        [/template]
        """);
    project.write(
        "eventchain.yaml",
        Files.readString(project.path().resolve("eventchain.yaml"))
            + "template: templates/main.mtl\n");
    new Program()
        .run("generate", project.path())
        .expect(2)
        .says(
            "The node of 'Radar_Tracking' does not convert the input 'distance_rate' between km/h and m/s.")
        .says("[simulation.manifest]");
    project.write(
        "templates/main.mtl",
        """
        [module main('http://eventchain.dev/eventchain/1.0')]
        [template public mine(chain : EventChain)]
        [comment @main /]
        [file ('nodes.txt', false, 'UTF-8')][chain.name/][/file]
        [/template]
        """);
    new Program()
        .run("generate", project.path())
        .expect(0)
        .says("it is not known whether the node of 'Brake_Request' converts 'closing_speed'")
        .says("[project.unit.unconverted]");
  }

  /** A model alone has no project around it that knows units. */
  @Test
  void aNodeThatCannotConvertDoesNotStart() throws IOException {
    Path out = folder.resolve("out");
    Path template = Program.ROOT.resolve("templates/ros2-python/main.mtl");
    Path model = project.path().resolve(CHAIN);
    new Program().run("generate", "--template", template, model, "-o", out).expect(0);
    assertTrue(
        Files.readString(out.resolve("radar_aeb/radar_aeb/radar_tracking_node.py"))
            .contains(
                "raise ValueError(\n            \"nothing is known that converts distance_rate between km/h and m/s\""));
  }
}
