package dev.eventchain.workspace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.node.TextNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.sandbox.PythonEnvironment;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WorkspaceTest {

  private static final Path RESOURCES = Path.of("src/test/resources");
  private static final PythonEnvironment PYTHON = PythonEnvironment.ensure(said -> {});

  /** Three packages, two launch files: what is known of them, and what is asked. */
  @Test
  void aWorkspaceIsASoftwareBase() throws IOException {
    Path workspace = RESOURCES.resolve("ws");
    checkFiles(files(workspace, Optional.empty()), workspace);
  }

  /** Each construct that is read, and each that is asked for. */
  @Test
  void whatIsNotKnownIsAsked() throws IOException {
    Path workspace = RESOURCES.resolve("corners");
    checkFiles(
        files(workspace, Optional.of(Path.of("src/corner_nodes/launch/all.launch.yaml"))),
        workspace);
  }

  /** Constructors get arguments, some of which are names of nodes and topics. */
  @Test
  void nodesAreThoseThatExecutablesMake() throws IOException {
    Path workspace = RESOURCES.resolve("made");
    checkFiles(files(workspace, Optional.empty()), workspace);
  }

  /**
   * Values and files of parameters, and topics, rates and quality of service that depend on them.
   */
  @Test
  void parametersAreThoseOfLaunch() throws IOException {
    Path workspace = RESOURCES.resolve("configured");
    checkFiles(
        files(workspace, Optional.of(Path.of("src/guard/launch/all.launch.xml"))), workspace);
  }

  /** Without a launch file that is the only one, executables are taken, and it is asked for. */
  @Test
  void severalLaunchFilesAreAskedFor(@TempDir Path folder) throws IOException {
    copy("ws", folder);
    Files.writeString(folder.resolve("src/braking/launch/other.launch.xml"), "<launch/>");
    FoundSoftware found = Workspace.read(folder, Optional.empty(), PYTHON);
    assertEquals(
        List.of("/brake", "/warning", "/tracker"),
        found.nodes().stream().map(FoundNode::name).toList());
    String question = found.questions().get(0).text();
    assertTrue(
        question.startsWith(
            "Which launch file starts the software: src/braking/launch/aeb.launch.py,"
                + " src/braking/launch/other.launch.xml?"),
        question);
  }

  /** The package may have been renamed since: an empty project would help nobody. */
  @Test
  void allNodesAreTakenWhereTheLaunchFileStartsNoneThatIsKnown(@TempDir Path folder)
      throws IOException {
    FoundSoftware found = launching(folder, "<node pkg='renamed' exec='brake'/>");
    assertEquals(
        List.of("/brake", "/warning", "/tracker"),
        found.nodes().stream().map(FoundNode::name).toList());
    assertTrue(
        asked(found, "What does the node 'brake' read and write? The package renamed is not in"));
    assertTrue(asked(found, "This file starts none that is known: each is taken once"));
  }

  @Test
  void nodesThatTheLaunchFileDoesNotStartAreNamed(@TempDir Path folder) throws IOException {
    FoundSoftware found = launching(folder, "<node pkg='braking' exec='brake'/>");
    assertEquals(List.of("/brake"), found.nodes().stream().map(FoundNode::name).toList());
    assertTrue(
        asked(found, "Are these nodes a part of the software: Warning, Tracker?"),
        found.questions()::toString);
  }

  /** A node that has other parameters is another one. */
  @Test
  void parametersOfLaunchFilesAreGivenToTheirNodes(@TempDir Path folder) throws IOException {
    FoundSoftware found =
        launching(
            folder,
            "<arg name='near' default='1.5'/><node pkg='braking' exec='brake'>"
                + "<param name='limit' value='$(var near)'/><param name='count' value='3'/>"
                + "<param name='use_sim_time' value='true'/><param name='side' value='left'/>"
                + "<param name='open' value='$(env OPEN)'/><param from='limits.yaml'/></node>");
    assertEquals(
        "{limit=1.5, count=3, side=\"left\"}",
        found.nodes().get(0).python().orElseThrow().parameters().toString());
    assertTrue(asked(found, "What is the parameter 'open' of this node?"));
    assertTrue(asked(found, "Which parameters does the file 'limits.yaml' give this node?"));
  }

  @Test
  void aParameterThatIsNoFiniteNumberIsAskedFor(@TempDir Path folder) throws IOException {
    Files.writeString(
        Files.createDirectories(folder.resolve("src/braking/launch")).resolve("far.launch.py"),
        """
        from launch import LaunchDescription
        from launch_ros.actions import Node

        def generate_launch_description():
            parameters = [{"most": 1e999, "least": 2.5}]
            return LaunchDescription([Node(package="braking", executable="brake", parameters=parameters)])
        """);
    FoundSoftware found =
        launching(folder, "<include file='$(find-pkg-share braking)/launch/far.launch.py'/>");
    assertEquals(
        "{least=2.5}", found.nodes().get(0).python().orElseThrow().parameters().toString());
    assertTrue(asked(found, "What is the parameter 'most' of this node?"));
  }

  /** What sets a variable counts from there on, also if it is not known. */
  @Test
  void variablesHaveNoEarlierValues(@TempDir Path folder) throws IOException {
    Path launch = Files.createDirectories(folder.resolve("src/braking/launch"));
    Files.writeString(
        launch.resolve("part.launch.xml"),
        "<launch><arg name='near' default='3'/><node pkg='braking' exec='brake' name='part'>"
            + "<param name='limit' value='$(var near)'/></node></launch>");
    Files.writeString(
        launch.resolve("all.launch.py"),
        """
        import os
        from launch import LaunchDescription
        from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, SetLaunchConfiguration
        from launch.launch_description_sources import AnyLaunchDescriptionSource
        from launch.substitutions import LaunchConfiguration
        from launch_ros.actions import Node
        from launch_ros.substitutions import FindPackageShare

        def generate_launch_description():
            limits = [{"limit": LaunchConfiguration("near")}]
            part = [FindPackageShare("braking"), "/launch/part.launch.xml"]
            unknown = {"near": os.environ["NEAR"]}.items()
            return LaunchDescription([
                DeclareLaunchArgument("near", default_value="1"),
                Node(package="braking", executable="brake", name="first", parameters=limits),
                SetLaunchConfiguration("near", "2"),
                Node(package="braking", executable="brake", name="second", parameters=limits),
                IncludeLaunchDescription(AnyLaunchDescriptionSource(part), launch_arguments=unknown),
                IncludeLaunchDescription(AnyLaunchDescriptionSource(part), launch_arguments=read()),
                SetLaunchConfiguration(name="near", value=os.environ["NEAR"]),
                Node(package="braking", executable="brake", name="last", parameters=limits),
            ])
        """);
    FoundSoftware found =
        launching(folder, "<include file='$(find-pkg-share braking)/launch/all.launch.py'/>");
    assertEquals(
        List.of("/first {limit=1}", "/second {limit=2}", "/part {}", "/part {}", "/last {}"),
        found.nodes().stream()
            .map(each -> each.name() + " " + each.python().orElseThrow().parameters())
            .toList());
    assertTrue(asked(found, "Which arguments does this give the included launch file?"));
  }

  private static FoundSoftware launching(Path folder, String started) throws IOException {
    copy("ws", folder);
    Files.delete(folder.resolve("src/braking/launch/aeb.launch.py"));
    Files.delete(folder.resolve("src/perception/radar_tracker/launch/perception.launch.xml"));
    Files.writeString(
        folder.resolve("src/braking/launch/one.launch.xml"), "<launch>" + started + "</launch>");
    return Workspace.read(folder, Optional.empty(), PYTHON);
  }

  private static boolean asked(FoundSoftware found, String text) {
    return found.questions().stream().anyMatch(each -> each.text().contains(text));
  }

  /** That it only reads is not true of a node that writes what is defined elsewhere. */
  @Test
  void aNodeWithATypeOfAnotherPackageStaysInTheChain(@TempDir Path folder) throws IOException {
    Path own = Files.createDirectories(folder.resolve("src/guard"));
    Files.writeString(
        own.resolve("package.xml"), "<package format='3'><name>guard</name></package>");
    Files.writeString(
        own.resolve("CMakeLists.txt"),
        "project(guard)\ninstall(PROGRAMS guard.py DESTINATION lib/guard)\n");
    Files.writeString(
        own.resolve("guard.py"),
        """
        import rclpy
        from ackermann_msgs.msg import AckermannDriveStamped
        from rclpy.node import Node
        from std_msgs.msg import Float32

        class Guard(Node):
            def __init__(self, limit, *, name="guard"):
                super().__init__(name)
                self.limit = limit
                self.drive = self.create_publisher(AckermannDriveStamped, "drive", 10)
                self.create_subscription(Float32, "ttc", self.on_ttc, 10)

            def on_ttc(self, ttc):
                if ttc.data < self.limit:
                    self.drive.publish(AckermannDriveStamped())

        rclpy.init()
        rclpy.spin(Guard(1.5))
        """);
    Map<String, String> files = files(folder, Optional.empty());
    assertTrue(files.get("components.json").contains("\"Guard\""));
    String questions = files.get("questions.json");
    assertFalse(questions.contains("only reads"), questions);
    assertTrue(questions.contains("add its package to the workspace"), questions);
    assertFalse(questions.contains("of Guard()"), questions); // its file makes it
  }

  /** A constructor may give parameters itself, and members for other types are zero. */
  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      quoteCharacter = '`',
      value = {
        "parameter_overrides=None; value; true",
        "use_global_arguments=True; get_parameter_value().double_value; true",
        "parameter_overrides=[Parameter('rate', value=50.0)]; value; false",
        "cli_args=['--ros-args', '-p', 'rate:=50.0']; value; false",
        "use_global_arguments=False; value; false",
        "namespace=''; get_parameter_value().integer_value; false"
      })
  void aRateIsKnownIfTheParameterOfLaunchIsThatOfTheNode(
      String option, String member, boolean isKnown, @TempDir Path folder) throws IOException {
    copy("ws", folder);
    Path module = folder.resolve("src/braking/braking/nodes.py");
    String source = Files.readString(module);
    String changed =
        source.replace(
            "super().__init__(\"brake\")",
            "super().__init__(\"brake\")\n        rate = self.declare_parameter(\"rate\", 20.0).%s\n        self.create_timer(1.0 / rate, print)"
                .formatted(member));
    assertNotEquals(source, changed);
    Files.writeString(
        module,
        changed.replace("super().__init__(name)", "super().__init__(name, " + option + ")"));
    FoundSoftware found = Workspace.read(folder, Optional.empty(), PYTHON);
    assertEquals(isKnown ? OptionalDouble.of(20) : OptionalDouble.empty(), frequencyOfBrake(found));
    assertEquals(!isKnown, asked(found, "What is the period of this timer: "));
  }

  private static OptionalDouble frequencyOfBrake(FoundSoftware found) {
    return found.nodes().stream()
        .filter(each -> each.description().startsWith("Brakes fully"))
        .findFirst()
        .orElseThrow()
        .frequency();
  }

  @Test
  void aLaunchFileThatIsNotThereIsRefused() {
    DiagnosticException refused =
        assertThrows(
            DiagnosticException.class,
            () -> Workspace.read(RESOURCES.resolve("ws"), Optional.of(Path.of("no.py")), PYTHON));
    Diagnostic found = refused.diagnostics().get(0);
    assertEquals("workspace.launch", found.id());
    assertTrue(found.hint().contains("src/braking/launch/aeb.launch.py"), found.hint());
  }

  @ParameterizedTest
  @CsvSource({"empty, workspace.empty", "missing, file.unreadable"})
  void whatIsNoWorkspaceIsRefused(String name, String id, @TempDir Path folder) throws IOException {
    Files.createDirectories(folder.resolve("empty/src"));
    DiagnosticException refused =
        assertThrows(
            DiagnosticException.class,
            () -> Workspace.read(folder.resolve(name), Optional.empty(), PYTHON));
    assertEquals(id, refused.diagnostics().get(0).id());
  }

  @Test
  void aReaderThatDoesNotEndWellIsAFinding() {
    DiagnosticException refused =
        assertThrows(
            DiagnosticException.class,
            () -> SourceReader.read(PYTHON, RESOURCES, TextNode.valueOf("no request")));
    assertEquals("workspace.unread", refused.diagnostics().get(0).id());
  }

  /** A package whose manifest is broken, or names it illegally, must not vanish. */
  @Test
  void packagesWithoutALegalNameAreAskedFor(@TempDir Path folder) throws IOException {
    copy("ws", folder);
    for (String manifest :
        List.of("<package><name>broken</name", "<package><name>No Name</name></package>")) {
      Path nameless = Files.createDirectories(folder.resolve("src/nameless"));
      Files.writeString(nameless.resolve("package.xml"), manifest);
      FoundSoftware found = Workspace.read(folder, Optional.empty(), PYTHON);
      assertEquals(
          1,
          found.questions().stream()
              .filter(it -> it.file().equals("src/nameless/package.xml"))
              .filter(it -> it.text().startsWith("What is the name of this package?"))
              .count(),
          manifest);
    }
  }

  /** Nothing of a workspace is run, whatever its files do or are. */
  @Test
  void hostileFilesAreAskedForAndNotRun(@TempDir Path folder) throws IOException {
    Path workspace = folder.resolve("ws");
    copy("ws", workspace);
    Path module = workspace.resolve("src/braking/braking");
    Path seen = folder.resolve("seen");
    String harmful = "open(" + '"' + seen + '"' + ", 'w')\n";
    Files.writeString(module.resolve("harmful.py"), harmful);
    Files.writeString(workspace.resolve("src/braking/setup.py"), harmful);
    Files.writeString(module.resolve("syntax.py"), "class :\n");
    Files.writeString(module.resolve("deep.py"), "x = " + "(".repeat(5_000) + ")".repeat(5_000));
    Files.writeString(module.resolve("sum.py"), "X = 1" + " + 1".repeat(50_000) + "\n");
    Files.write(module.resolve("binary.py"), new byte[] {0, 1, (byte) 0xff});
    Files.writeString(module.resolve("huge.py"), "#".repeat((1 << 20) + 1));
    Files.writeString(folder.resolve("secret.py"), "class Secret: pass\n");
    Files.createSymbolicLink(module.resolve("outside.py"), folder.resolve("secret.py"));
    Files.createSymbolicLink(module.resolve("circle"), workspace.resolve("src"));
    Files.createSymbolicLink(module.resolve("nothing.py"), folder.resolve("nowhere.py"));
    Files.writeString(
        workspace.resolve("src/braking/launch/evil.launch.xml"),
        "<!DOCTYPE a [<!ENTITY b SYSTEM 'file:///etc/passwd'>]><launch>&b;</launch>");
    FoundSoftware found =
        Workspace.read(workspace, Optional.of(Path.of("src/braking/launch/aeb.launch.py")), PYTHON);
    assertFalse(Files.exists(seen));
    assertEquals(3, found.nodes().size());
    for (String name : List.of("syntax", "deep", "binary", "huge", "outside", "nothing")) {
      String file = "src/braking/braking/" + name + ".py";
      assertTrue(found.questions().stream().anyMatch(it -> it.file().equals(file)), file);
    }
    assertTrue(found.questions().stream().anyMatch(it -> it.file().endsWith("evil.launch.xml")));
  }

  private static Map<String, String> files(Path workspace, Optional<Path> launch) {
    return SoftwareBaseFiles.of(
        Workspace.read(workspace, launch, PYTHON), MessageCatalog.of(List.of(workspace)));
  }

  private static void checkFiles(Map<String, String> files, Path workspace) throws IOException {
    Path expected = workspace.resolveSibling(workspace.getFileName() + ".expected");
    assertEquals(
        files.keySet().stream()
            .filter(name -> name.endsWith(".msg") || name.startsWith("nodes/"))
            .count(),
        files.keySet().size() - 3L);
    for (String name : List.of("components", "signals", "questions")) {
      String file = name + ".json";
      ExpectedFile.check(expected.resolve(file), files.get(file));
    }
  }

  private static void copy(String name, Path to) throws IOException {
    Path from = RESOURCES.resolve(name);
    try (var files = Files.walk(from)) {
      for (Path file : files.toList()) {
        Path target = to.resolve(from.relativize(file).toString());
        if (Files.isDirectory(file)) {
          Files.createDirectories(target);
        } else {
          Files.copy(file, target);
        }
      }
    }
  }
}
