package dev.eventchain.messages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ServiceParserTest {

  @TempDir private Path folder;

  @Test
  void aServiceIsItsRequestAndItsResponse() throws IOException {
    write("arm_msgs/srv/Move.srv", "Pose pose\r\n---\r\n#nothing\nstring text\n");
    write("arm_msgs/srv/Stop.srv", "---");
    write("arm_msgs/msg/Pose.msg", "float64 x\n");
    MessageCatalog catalog = MessageCatalog.of(List.of(folder));
    assertEquals(List.of(), catalog.diagnostics());
    assertEquals(Set.of("arm_msgs/msg/Pose"), catalog.ownNames(), "a service is no message");
    assertEquals("arm_msgs/msg/Pose pose", onlyField(catalog, "arm_msgs/srv/Move_Request"));
    assertEquals("string text", onlyField(catalog, "arm_msgs/srv/Move_Response"));
    String empty = "\"arm_msgs/srv/Stop_Response\": {\"fields\": []";
    assertTrue(catalog.ownDefinitions().contains(empty), catalog.ownDefinitions());
  }

  private static String onlyField(MessageCatalog catalog, String type) {
    List<MessageType.Field> fields = catalog.find(type).orElseThrow().fields();
    assertEquals(1, fields.size());
    return fields.get(0).type() + " " + fields.get(0).name();
  }

  @Test
  void mistakesAreFoundWhereTheyAre() throws IOException {
    write("arm_msgs/Lost.srv", "---\n");
    write("arm_msgs/srv/Go.srv", "int8 a\n");
    write("arm_msgs/srv/Move.srv", "int8 code=300\n---\nint32 number\nfloat number\n");
    write("arm_msgs/srv/Stop.srv", "int8 a\n---\nint8 b\n---\nint8 c\n");
    assertEquals(
        List.of(
            "message.place Lost.srv:0",
            "message.syntax Go.srv:1",
            "message.value Move.srv:1",
            "message.syntax Move.srv:4",
            "message.syntax Stop.srv:4"),
        MessageCatalog.of(List.of(folder)).diagnostics().stream().map(this::line).toList());
  }

  private String line(Diagnostic found) {
    Path file = Path.of(found.location().file());
    return String.format(
        Locale.ROOT, "%s %s:%d", found.id(), file.getFileName(), found.location().line());
  }

  private void write(String file, String text) throws IOException {
    Path path = folder.resolve(file);
    Files.createDirectories(path.getParent());
    Files.writeString(path, text);
  }
}
