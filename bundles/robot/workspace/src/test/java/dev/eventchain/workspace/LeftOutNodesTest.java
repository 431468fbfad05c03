package dev.eventchain.workspace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.sandbox.PythonEnvironment;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests which nodes of a workspace begin no chain and end none. */
class LeftOutNodesTest {

  private static final PythonEnvironment PYTHON = PythonEnvironment.ensure(said -> {});

  @TempDir Path folder;

  /** Neither services nor transforms are data of a chain, and both are asked about. */
  @Test
  void aNodeThatOnlyReadsIsLeftOutAlthoughItSendsTransforms() throws IOException {
    Path source = folder.resolve("src/base");
    Files.createDirectories(source.resolve("base"));
    Files.writeString(source.resolve("package.xml"), "<package><name>base</name></package>");
    Files.writeString(
        source.resolve("setup.py"),
        "setup(s=['odom = base.odom:main', 'unclear = base.odom:two'])");
    Files.writeString(source.resolve("base/__init__.py"), "");
    Files.createDirectories(source.resolve("srv"));
    Files.createDirectories(source.resolve("msg"));
    Files.writeString(source.resolve("srv/SetMode.srv"), "Mode mode\n---\nbool done\n");
    Files.writeString(source.resolve("srv/Other.srv"), "---\n");
    Files.writeString(source.resolve("msg/Mode.msg"), "uint8 STAND=0\nuint8 value\n");
    Files.writeString(source.resolve("msg/Limits.msg"), "float32 MOST=2.0\n");
    Files.writeString(source.resolve("msg/Unused.msg"), "bool unused\n");
    Files.writeString(
        source.resolve("base/odom.py"),
        """
        import rclpy
        from nav_msgs.msg import Odometry
        from rclpy.node import Node
        from base.msg import Limits
        from base.srv import SetMode
        from tf2_ros import TransformBroadcaster

        class Odom(Node):
            def __init__(self):
                super().__init__("odom")
                self.sender = TransformBroadcaster(self)
                self.create_service(SetMode, "mode", self.mode)
                self.create_subscription(Odometry, "odom", self.read, 10)

            def read(self, message):
                self.speed = message.twist.twist.linear.x

        class Unclear(Node):
            def __init__(self):
                super().__init__("unclear")
                self.create_subscription(Odometry, "odom", self.read, 10)
                self.create_publisher(Odometry, input(), 10)

            def read(self, message):
                self.speed = message.twist.twist.linear.x

        def main():
            rclpy.spin(Odom())

        def two():
            rclpy.spin(Unclear())
        """);
    Map<String, String> files =
        SoftwareBaseFiles.of(
            Workspace.read(folder, Optional.empty(), PYTHON), MessageCatalog.of(List.of(folder)));
    assertEquals(
        List.of("msg/base/msg/Limits.msg", "msg/base/msg/Mode.msg", "msg/base/srv/SetMode.srv"),
        files.keySet().stream().filter(each -> each.startsWith("msg/")).toList(),
        "what the modules import");
    String components = files.get("components.json");
    assertFalse(components.contains("\"Odom\""), components);
    assertTrue(components.contains("\"Unclear\""), "what it writes is not known: " + components);
    String questions = files.get("questions.json");
    for (String part :
        List.of(
            "Odom has a broadcaster of transforms",
            "Odom has a service",
            "Is /odom a part of the vehicle? It only reads, and is left out of the chain.")) {
      assertTrue(questions.contains(part), questions);
    }
    assertEquals(-1, questions.indexOf("Is /unclear a part"), questions);
  }
}
