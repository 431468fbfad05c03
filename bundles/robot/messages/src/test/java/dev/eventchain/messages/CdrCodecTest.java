package dev.eventchain.messages;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class CdrCodecTest {

  /** Written by src/test/python/random_messages.py in this build. */
  private static final Path MESSAGES_OF_ROSBAGS = Path.of("target/random-messages.jsonl");

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final MessageCatalog CATALOG =
      MessageCatalog.of(List.of(Path.of("conformance/definitions")));

  static List<String> messagesOfRosbags() throws IOException {
    return Files.readAllLines(MESSAGES_OF_ROSBAGS);
  }

  @Test
  void everyStandardTypeIsTried() throws IOException {
    Set<String> tried = new TreeSet<>();
    for (String line : messagesOfRosbags()) {
      tried.add(JSON.readTree(line).get("type").asText());
    }
    assertEquals(CATALOG.names(), tried);
    assertTrue(tried.size() >= 150);
  }

  @Test
  void bytesAndValuesAreThoseOfRosbags() throws IOException {
    for (String line : messagesOfRosbags()) {
      JsonNode expected = JSON.readTree(line);
      MessageType type = CATALOG.find(expected.get("type").asText()).orElseThrow();
      byte[] bytes = HexFormat.of().parseHex(expected.get("cdr").asText());
      MessageValue decoded = CdrCodec.decode(type, bytes);
      assertEquals(PlainMessages.read(type, expected.get("value")), decoded);
      assertArrayEquals(bytes, CdrCodec.encode(decoded), type::name);
    }
  }

  @Test
  void messagesMadeFromValuesHaveTheBytesOfRosbags() throws IOException {
    for (String line : messagesOfRosbags()) {
      JsonNode expected = JSON.readTree(line);
      MessageType type = CATALOG.find(expected.get("type").asText()).orElseThrow();
      MessageValue made = PlainMessages.read(type, expected.get("value"));
      assertEquals(
          expected.get("cdr").asText(),
          HexFormat.of().formatHex(CdrCodec.encode(made)),
          type::name);
    }
  }

  @Test
  void bytesInBigEndianOrderAreReadToo() throws IOException {
    int different = 0;
    for (String line : messagesOfRosbags()) {
      JsonNode expected = JSON.readTree(line);
      MessageType type = CATALOG.find(expected.get("type").asText()).orElseThrow();
      byte[] bytes = HexFormat.of().parseHex(expected.get("cdr_big_endian").asText());
      assertEquals(0, bytes[1], type::name);
      assertEquals(PlainMessages.read(type, expected.get("value")), CdrCodec.decode(type, bytes));
      different += expected.get("cdr").equals(expected.get("cdr_big_endian")) ? 0 : 1;
    }
    assertTrue(different >= 150, "only " + different + " differ from little-endian ones");
  }

  @Test
  void aMessageIsRecognizedByItsLengthWithoutBeingRead() throws IOException {
    for (String line : messagesOfRosbags()) {
      JsonNode expected = JSON.readTree(line);
      MessageType type = CATALOG.find(expected.get("type").asText()).orElseThrow();
      for (String order : List.of("cdr", "cdr_big_endian")) {
        byte[] bytes = HexFormat.of().parseHex(expected.get(order).asText());
        CdrCodec.requireMessage(type, bytes);
        CdrCodec.requireMessage(type, Arrays.copyOf(bytes, bytes.length + 3));
        for (int length : new int[] {0, 3, bytes.length - 1, bytes.length + 4}) {
          byte[] wrong = Arrays.copyOf(bytes, length);
          assertThrows(
              IllegalArgumentException.class,
              () -> CdrCodec.requireMessage(type, wrong),
              () -> type + " with " + length + " of " + bytes.length + " bytes");
        }
      }
    }
  }

  @Test
  void countsThatAreNoCountsAreNotRecognized() {
    MessageType type = CATALOG.find("std_msgs/msg/Float64MultiArray").orElseThrow();
    for (String count : List.of("ffffff7f", "ffffffff", "00000080", "00000020")) {
      byte[] bytes = HexFormat.of().parseHex("00010000" + count + "00000000".repeat(8));
      assertThrows(
          IllegalArgumentException.class, () -> CdrCodec.requireMessage(type, bytes), count);
    }
  }

  @Test
  void typeHashesAreThoseOfRosbags() throws IOException {
    int compared = 0;
    for (String line : messagesOfRosbags()) {
      JsonNode expected = JSON.readTree(line);
      MessageType type = CATALOG.find(expected.get("type").asText()).orElseThrow();
      if (!usesChar(type)) { // a separate type in rosbags, uint8 in ROS 2
        assertEquals(expected.get("hash").asText(), type.hash(), type::name);
        compared++;
      }
    }
    assertTrue(compared >= 700, "only " + compared);
  }

  private static boolean usesChar(MessageType type) {
    return type.fields().stream()
        .map(MessageType.Field::type)
        .anyMatch(
            field ->
                field.kind() == FieldType.Kind.CHAR
                    || field.message().filter(CdrCodecTest::usesChar).isPresent());
  }

  @Test
  void theHashOfCharIsThatOfUint8() {
    MessageCatalog catalog =
        MessageCatalog.ofTexts(
            Map.of("std_msgs/msg/Char", "uint8 data\n", "std_msgs/msg/UInt8", "char data\n"));
    for (String name : List.of("std_msgs/msg/Char", "std_msgs/msg/UInt8")) {
      assertEquals(
          CATALOG.find(name).orElseThrow().hash(), catalog.find(name).orElseThrow().hash());
    }
    assertNotEquals(
        CATALOG.find("std_msgs/msg/Char").orElseThrow().hash(),
        CATALOG.find("std_msgs/msg/UInt8").orElseThrow().hash());
  }

  @Test
  void truncatedBytesAreRefusedAtEveryLength() throws IOException {
    MessageType type = CATALOG.find("sensor_msgs/msg/PointCloud2").orElseThrow();
    MessageValue cloud = MessageValue.of(type).set("data", new byte[7]);
    MessageType field = CATALOG.find("sensor_msgs/msg/PointField").orElseThrow();
    cloud.set("fields", List.of(MessageValue.of(field).set("name", "x")));
    byte[] bytes = CdrCodec.encode(cloud);
    for (int length = 0; length < bytes.length; length++) {
      int cut = length;
      assertThrows(
          IllegalArgumentException.class, () -> CdrCodec.decode(type, bytes, 0, cut), "" + cut);
    }
    assertEquals(cloud, CdrCodec.decode(type, bytes));
  }

  @Test
  void wrongCountDoesNotTakeMemory() {
    MessageType type = CATALOG.find("std_msgs/msg/Float64MultiArray").orElseThrow();
    byte[] bytes = HexFormat.of().parseHex("00010000ffffff7fffffff7fffffff7fffffff7f");
    assertThrows(IllegalArgumentException.class, () -> CdrCodec.decode(type, bytes));
  }

  @Test
  void bigEndianAndPartsOfArraysAreRead() {
    MessageType type = CATALOG.find("std_msgs/msg/Int32MultiArray").orElseThrow();
    byte[] bytes = HexFormat.of().parseHex("aa0000000000000000000000050000000100000002bb");
    MessageValue value = CdrCodec.decode(type, bytes, 1, bytes.length - 2);
    assertEquals(5.0, value.number("layout.data_offset"));
    assertArrayEquals(new int[] {2}, (int[]) value.get("data"));
  }

  @Test
  void otherRepresentationsAreNamed() {
    MessageType type = CATALOG.find("std_msgs/msg/Bool").orElseThrow();
    byte[] parameterList = {0, 3, 0, 0, 1};
    IllegalArgumentException problem =
        assertThrows(IllegalArgumentException.class, () -> CdrCodec.decode(type, parameterList));
    assertEquals("Representation 3 is not plain CDR (0 or 1).", problem.getMessage());
  }

  @ParameterizedTest
  @MethodSource("pointCounts")
  void largeDataSurvivesUnchanged(int points) {
    MessageType type = CATALOG.find("sensor_msgs/msg/PointCloud2").orElseThrow();
    byte[] data = new byte[points * 16];
    new java.util.Random(points).nextBytes(data);
    MessageValue cloud = MessageValue.of(type).set("data", data).set("header.frame_id", "lidar");
    MessageValue decoded = CdrCodec.decode(type, CdrCodec.encode(cloud));
    assertArrayEquals(data, (byte[]) decoded.get("data"));
    assertEquals("lidar", decoded.get("header.frame_id"));
  }

  static List<Integer> pointCounts() {
    return new ArrayList<>(List.of(0, 1, 31, 2000, 100_000));
  }
}
