package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests the choice of the release of ROS 2 that defines the standard messages, on a chain with a
 * message that Humble does not have.
 */
class RosDistributionTest {

  private static final String CHAIN = "model/chain.xmi";
  private static final String COMPONENTS = "software-base/components.json";
  private static final String SIGNALS = "software-base/signals.json";
  private static final String CONFIGURATION = "eventchain.yaml";
  private static final String NAME = "name: radar_aeb\n";
  private static final String[][] FIELDS = {
    {"closing_speed", "velocity.linear.x"}, {"time_to_collision", "velocity.linear.y"}
  };
  private static final String HINT =
      "ROS 2 Jazzy has it, and the messages used here are those of Humble: see 'ros_distro' in eventchain.yaml.";

  @TempDir private Path folder;
  private ProjectCopy project;

  @BeforeEach
  void createProject() throws IOException {
    project = ProjectCopy.of("radar-aeb", folder);
    project.onlyScenario("scenarios/stopped-vehicle-50.yaml");
    for (String file : List.of(CHAIN, COMPONENTS, SIGNALS)) {
      String text = Files.readString(project.path().resolve(file));
      String changed = text.replace("demo_msgs/msg/Threat", "geometry_msgs/msg/VelocityStamped");
      for (String[] field : FIELDS) {
        changed =
            changed.replaceAll(
                "(?i)(\"?field(Name)?\"?[=:] ?\")" + field[0] + "(\"[^>}]*?type\"?[=:] ?\"float)32",
                "$1" + field[1] + "$364");
      }
      project.write(file, changed);
    }
  }

  private void use(String distribution) throws IOException {
    project.replace(CONFIGURATION, NAME, NAME + "ros_distro: " + distribution + "\n");
  }

  @Test
  void messagesOfJazzyRunAndAreRefusedAsThoseOfHumble() throws IOException {
    use("jazzy");
    project.run().expect(0).says("PASSED: 1 of 1 scenarios passed");
    new Program().run("validate", project.path().resolve(CHAIN)).expect(0);
    new Program()
        .run("doctor", project.path())
        .says("those of Jazzy ('ros_distro' in eventchain.yaml: humble or jazzy)");
    new Program()
        .run("messages", project.path().resolve("software-base/msg"))
        .expect(0)
        .says("geometry_msgs/msg/VelocityStamped");
    project.replace(CONFIGURATION, "ros_distro: jazzy\n", "");
    project.run().expect(1).says("[contract.message.unknown]").says("hint: " + HINT);
    project.requireNotPassed();
    new Program().run("validate", project.path().resolve(CHAIN)).expect(1).says(HINT);
    Program.Ended messages =
        new Program().run("messages", project.path().resolve("software-base/msg")).expect(0);
    assertTrue(!messages.out().contains("VelocityStamped"), messages.out());
  }

  @Test
  void anUnknownReleaseIsRefusedWithItsLine() throws IOException {
    use("kilted");
    String place = "eventchain.yaml:3:13: error: The messages of ROS 2 'kilted' are not known.";
    new Program().run("run", project.path()).expect(2).says(place).says("Use humble or jazzy");
    new Program().run("validate", project.path()).says(place);
    new Program().run("validate", project.path().resolve(CHAIN)).says(place);
  }

  @Test
  void definitionsForNodesThatRunAlone() {
    Path messages = project.path().resolve("software-base/msg");
    new Program()
        .run("messages", "--ros-distro", "jazzy", messages)
        .expect(0)
        .says("geometry_msgs/msg/VelocityStamped")
        .says("demo_msgs/msg/RadarTarget");
    new Program()
        .run("messages", "--ros-distro", "jazzy")
        .expect(0)
        .says("geometry_msgs/msg/VelocityStamped");
    new Program().run("messages").expect(2).says("name a folder, or --ros-distro");
    new Program()
        .run("messages", "--ros-distro", "kilted", messages)
        .expect(2)
        .says("--ros-distro is humble or jazzy, not 'kilted'");
  }
}
