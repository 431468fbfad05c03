package dev.eventchain.benchmarks;

import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.SortedMap;
import java.util.TreeMap;

/** The equivalent of {@code nodes.mtl}, written by hand in direct Java. */
final class NodeFiles {

  private final StringBuilder text = new StringBuilder();

  private NodeFiles() {}

  /** Returns the content of each file by its name. */
  static SortedMap<String, byte[]> of(EventChain chain) {
    SortedMap<String, byte[]> files = new TreeMap<>();
    NodeFiles writer = new NodeFiles();
    for (SoftwareNode node : chain.getSoftware()) {
      files.put(nameOf(node), writer.file(node).getBytes(StandardCharsets.UTF_8));
    }
    return files;
  }

  static String nameOf(SoftwareNode node) {
    return node.getName().toLowerCase(Locale.ROOT) + "_node.py";
  }

  private String file(SoftwareNode node) {
    String name = node.getName();
    text.setLength(0);
    text.append("import rclpy\nfrom rclpy.node import Node\n");
    node.getInput().forEach(this::importOf);
    node.getOutput().forEach(this::importOf);
    text.append("from ").append(name).append(" import ").append(name);
    text.append("\n\nclass ").append(name).append("_node(Node):\n    def __init__(self):\n");
    text.append("        super().__init__('").append(name).append("_node')\n");
    text.append("        self.").append(name).append(" = ").append(name).append("()\n");
    for (Data data : node.getInput()) {
      text.append("        self.").append(data.getName()).append(" = None\n");
    }
    connections(node);
    text.append("        self.timer = self.create_timer(1.0/").append(node.getFrequency());
    text.append(", self.execute)\n\n");
    for (Data data : node.getInput()) {
      text.append("    def ").append(data.getName()).append("_callback(self, data):\n");
      text.append("        self.").append(data.getName()).append(" = data.");
      text.append(data.getFieldName()).append("\n\n");
    }
    execution(node);
    text.append("\n\ndef main(args=None):\n    rclpy.init(args=args)\n    node = ").append(name);
    text.append("_node()\n    rclpy.spin(node)\n    node.destroy_node()\n    rclpy.shutdown()\n");
    text.append("\n\nif __name__ == '__main__':\n    main()\n");
    return text.toString();
  }

  private void importOf(Data data) {
    String type = data.getMessageType();
    text.append("from ").append(type, 0, type.indexOf('/')).append(".msg import ");
    text.append(classOf(data)).append('\n');
  }

  private static String classOf(Data data) {
    return data.getMessageType().substring(data.getMessageType().lastIndexOf('/') + 1);
  }

  private void connections(SoftwareNode node) {
    for (Data data : node.getInput()) {
      text.append("        self.").append(data.getName());
      text.append("_subscriber = self.create_subscription(").append(classOf(data));
      text.append(", \"").append(data.getTopicName()).append("\", self.").append(data.getName());
      text.append("_callback, qos_profile=10)\n");
    }
    for (Data data : node.getOutput()) {
      text.append("        self.").append(data.getName());
      text.append("_publisher = self.create_publisher(").append(classOf(data));
      text.append(", \"").append(data.getTopicName()).append("\", qos_profile=10)\n");
    }
  }

  private void execution(SoftwareNode node) {
    text.append("    def execute(self):\n");
    for (Data data : node.getInput()) {
      text.append("        if self.").append(data.getName()).append(" is None:\n");
      text.append("            self.get_logger().warn(\"msg not received\")\n            return\n");
    }
    text.append("        output = self.").append(node.getName()).append(".execute(");
    String separator = "";
    for (Data data : node.getInput()) {
      text.append(separator).append(data.getName()).append("=self.").append(data.getName());
      separator = ", ";
    }
    text.append(")\n");
    for (Data data : node.getOutput()) {
      String name = data.getName();
      text.append("        ").append(name).append("_msg = ").append(classOf(data)).append("()\n");
      text.append("        ").append(name).append("_msg.").append(data.getFieldName());
      text.append(" = output['").append(name).append("']\n        self.").append(name);
      text.append("_publisher.publish(").append(name).append("_msg)\n");
    }
  }
}
