package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.Projects;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that {@code init} makes a project of a ROS 2 workspace, which says what is not known. */
class InitWorkspaceTest {

  private static final Path WORKSPACE =
      Program.ROOT.resolve("bundles/robot/workspace/src/test/resources/ws");

  @TempDir private Path folder;

  @Test
  void aWorkspaceIsAProjectThatValidatesOnceItsTopicsAreKnown() throws IOException {
    Path workspace = folder.resolve("ws");
    Projects.copy(WORKSPACE, workspace);
    Path nodes = workspace.resolve("src/braking/braking/nodes.py");
    String parameter = "self.declare_parameter(\"topic\")";
    Files.writeString(
        nodes,
        Files.readString(nodes)
            .replace("self.declare_parameter(\"topic\", \"/warning\")", parameter));
    Path project = folder.resolve("aeb");
    new Program()
        .run("init", project, "--from-workspace", workspace)
        .expect(0)
        .says("software-base/msg/demo_msgs/msg/Threat.msg")
        .says("src/braking/braking/nodes.py:40: What is the topic of this publisher");
    new Program()
        .run("validate", project)
        .expect(1)
        .says("SoftwareNode 'Warning' violates 'HasInputAndOutputData'")
        .says("[project.question]");
    Path known = folder.resolve("known");
    new Program().run("init", known, "--from-workspace", WORKSPACE).expect(0);
    new Program().run("validate", known).expect(0).says("How often does Warning act?");
    new Program().run("run", known, "--no-strength").expect(1).says("passed  stopped-vehicle");
    argumentsDecide(known);
  }

  /** A node is made as its file makes it; what that leaves open is found, and described. */
  private static void argumentsDecide(Path project) throws IOException {
    Path nodes = project.resolve("software-base/nodes/braking/nodes.py");
    String made =
        Files.readString(nodes)
            .replace(
                "__init__(self):\n        super().__init__(\"brake\")",
                "__init__(self, limit):\n        super().__init__(\"brake\")\n        self.full_brake_ttc = limit");
    Files.writeString(nodes, made.replace("Brake()", "Brake(float(sys.argv[1]))"));
    new Program()
        .run("validate", project)
        .expect(1)
        .says("nodes.py:49:22: error: An argument of Brake() is not known before it runs")
        .says("[component.node.arguments]");
    Files.writeString(nodes, made.replace("Brake()", "Brake(2 * 0.8)"));
    new Program().run("run", project, "--no-strength").says("passed  stopped-vehicle");
    Path components = project.resolve("software-base/components.json");
    String named = "\"class\": \"Brake\"";
    Files.writeString(
        components,
        Files.readString(components).replace(named, named + ", \"arguments\": {\"limit\": 0.1}"));
    new Program()
        .run("run", project, "--no-strength")
        .expect(1)
        .says("components.json makes Brake with other arguments than this: 'limit'")
        .says("FAILED  stopped-vehicle");
  }

  /** Scripts of two packages may have one name, and would be one file in the generated package. */
  @Test
  void scriptsOfOneNameAreNotMistakenForEachOther() throws IOException {
    Path workspace = folder.resolve("scripts");
    script(workspace.resolve("src/one"), "first", "second");
    script(workspace.resolve("src/two"), "second", "third");
    Path project = folder.resolve("relays");
    new Program()
        .run("init", project, "--from-workspace", workspace)
        .expect(0)
        .says("software-base/nodes/two/scripts/relay.py");
    new Program()
        .run("generate", project)
        .expect(1)
        .says("nodes/two/scripts/relay.py: error: Another node needs another module of this name")
        .says("[component.import.helper]");
    Path other = project.resolve("software-base/nodes/two/scripts/relay.py");
    Files.move(other, other.resolveSibling("relay_of_two.py"));
    Path components = project.resolve("software-base/components.json");
    String text = Files.readString(components);
    Files.writeString(components, text.replace("two/scripts/relay", "two/scripts/relay_of_two"));
    new Program().run("generate", project).expect(0);
    Path nodes = project.resolve("software-base/nodes");
    asPackage(nodes.resolve("one/scripts/relay.py"), nodes.resolve("pkg_a/pkg_a"));
    asPackage(other.resolveSibling("relay_of_two.py"), nodes.resolve("pkg_b/pkg_b"));
    Files.writeString(
        components,
        text.replace("one/scripts", "pkg_a/pkg_a").replace("two/scripts", "pkg_b/pkg_b"));
    new Program().run("generate", project).expect(0);
    try (Stream<Path> files = Files.walk(project.resolve("out/ros2"))) {
      assertEquals(
          Set.of("pkg_a", "pkg_b"),
          files
              .filter(file -> file.endsWith("relay.py"))
              .map(file -> file.getParent().getFileName().toString())
              .collect(Collectors.toSet()));
    }
  }

  /** Moves a node into a package with the files that ament_python puts beside it. */
  private static void asPackage(Path node, Path inner) throws IOException {
    Files.createDirectories(inner.resolveSibling("test"));
    Files.move(node, Files.createDirectories(inner).resolve("relay.py"));
    Files.writeString(inner.resolve("__init__.py"), "");
    String setup = "from setuptools import setup\n\nsetup(name=\"" + inner.getFileName() + "\")\n";
    Files.writeString(inner.resolveSibling("setup.py"), setup);
    Files.writeString(inner.resolveSibling("test/test_relay.py"), "# " + setup);
  }

  private static void script(Path owner, String input, String output) throws IOException {
    Files.createDirectories(owner.resolve("scripts"));
    String name = owner.getFileName().toString();
    Files.writeString(owner.resolve("package.xml"), "<package><name>" + name + "</name></package>");
    Files.writeString(
        owner.resolve("CMakeLists.txt"),
        "install(PROGRAMS scripts/relay.py DESTINATION lib/" + name + ")\n");
    Files.writeString(
        owner.resolve("scripts/relay.py"),
        """
        import rclpy
        from rclpy.node import Node
        from std_msgs.msg import Float32

        class Relay(Node):
            def __init__(self):
                super().__init__("%s")
                self.output = self.create_publisher(Float32, "%s", 1)
                self.create_subscription(Float32, "%s", self.on_input, 1)

            def on_input(self, message):
                self.output.publish(Float32(data=message.data))

        if __name__ == "__main__":
            rclpy.init()
            rclpy.spin(Relay())
        """
            .formatted(name, output, input));
  }

  @Test
  void aRecordingIsAProjectWithSignals() throws IOException {
    Path recordings = WORKSPACE.resolveSibling("recordings");
    for (String name : List.of("peer.mcap", "bag", "sqlite-with-definitions")) {
      Path project = folder.resolve(name);
      String option = name.endsWith(".mcap") ? "--from-mcap" : "--from-bag";
      new Program()
          .run("init", project, option, recordings.resolve(name))
          .expect(0)
          .says("software-base/msg/demo_msgs/msg/Target.msg")
          .says("Who writes and who reads /radar/target (41 messages, 20.0 Hz on average)?");
      new Program().run("bench", project).expect(0).says("provides /radar/target");
      assertTrue(Files.readString(project.resolve("bench.yaml")).contains("rate_hz: 5\n"), name);
    }
    new Program()
        .run("init", folder.resolve("no"), "--from-mcap", WORKSPACE)
        .expect(2)
        .says("[workspace.recording]");
  }

  @Test
  void whatIsNoWorkspaceLeavesNothingBehind() throws IOException {
    Path project = folder.resolve("new");
    new Program()
        .run("init", project, "--from-workspace", Files.createDirectory(folder.resolve("empty")))
        .expect(2)
        .says("[workspace.empty]");
    assertFalse(Files.exists(project));
    new Program()
        .run("init", project, "--from-workspace", WORKSPACE, "--launch", "no.launch.py")
        .expect(2)
        .says("[workspace.launch]");
    assertFalse(Files.exists(project));
    new Program().run("init", project, "--launch", "a").expect(2).says("--launch is about");
    Files.createDirectories(project.resolve("mine"));
    new Program()
        .run("init", project, "--from-workspace", WORKSPACE)
        .expect(2)
        .says("[project.foreign]");
  }
}
