package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.Projects;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that {@code init} makes a project of a ROS 2 workspace, which says what is not known. */
class InitWorkspaceTest {

  private static final Path WORKSPACE =
      Program.ROOT.resolve("bundles/robot/workspace/src/test/resources/ws");

  @TempDir private Path folder;

  @Test
  void aWorkspaceIsAProjectThatValidatesOnceItsTopicsAreKnown() throws IOException {
    Path project = folder.resolve("aeb");
    new Program()
        .run("init", project, "--from-workspace", WORKSPACE)
        .expect(0)
        .says("software-base/msg/demo_msgs/msg/Threat.msg")
        .says("src/braking/braking/nodes.py:40: What is the topic of this publisher");
    new Program()
        .run("validate", project)
        .expect(1)
        .says("SoftwareNode 'Warning' violates 'HasInputAndOutputData'")
        .says("[project.question]");
    Path workspace = folder.resolve("ws");
    Projects.copy(WORKSPACE, workspace);
    Path nodes = workspace.resolve("src/braking/braking/nodes.py");
    String parameter = "self.declare_parameter(\"topic\", \"/warning\").value";
    Files.writeString(nodes, Files.readString(nodes).replace(parameter, "\"/warning\""));
    Path known = folder.resolve("known");
    new Program().run("init", known, "--from-workspace", workspace).expect(0);
    new Program().run("validate", known).expect(0).says("How often does Warning act?");
    new Program().run("run", known, "--no-strength").expect(1).says("passed  stopped-vehicle");
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
