package dev.eventchain.messages;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.ExpectedFile;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The files that the Python runtime is also tested against. */
class ConformanceTest {

  private static final Path FOLDER = Path.of("conformance");
  private static final Path RUNTIME = Path.of("../runtime/python/eventchain_ros2");
  private static final ObjectMapper JSON = new ObjectMapper();
  private static final MessageCatalog CATALOG =
      MessageCatalog.of(List.of(FOLDER.resolve("definitions")));

  private static final MessageCatalog JAZZY = MessageCatalog.of(RosDistribution.JAZZY, List.of());

  /** Types with a {@code char}, a separate type in rosbags and uint8 in ROS 2. */
  private static final Set<String> OF_CHARACTERS =
      Set.of("rmw_dds_common/msg/Gid", "service_msgs/msg/ServiceEventInfo");

  @Test
  void definitionsAreResolvedAsExpected() throws IOException {
    assertEquals(List.of(), CATALOG.diagnostics());
    ExpectedFile.check(FOLDER.resolve("definitions.json"), CATALOG.ownDefinitions());
  }

  @Test
  void standardTypesOfTheRuntimeAreThoseOfHere() throws IOException {
    MessageCatalog standard = MessageCatalog.of(List.of());
    ExpectedFile.check(RUNTIME.resolve("humble.json"), standard.definitions(standard.names()));
  }

  @Test
  void servicesOfTheRuntimeAreThoseOfItsDefinitions() throws IOException {
    MessageCatalog services =
        MessageCatalog.of(List.of(Path.of("../runtime/definitions").toAbsolutePath()));
    assertEquals(List.of(), services.diagnostics());
    ExpectedFile.check(RUNTIME.resolve("services.json"), services.ownDefinitions());
  }

  @Test
  void typesOfJazzyAreResolvedAsExpected() throws IOException {
    ExpectedFile.check(FOLDER.resolve("jazzy.json"), JAZZY.ownDefinitions());
  }

  static List<JsonNode> messages() throws IOException {
    return lines("messages.jsonl");
  }

  static List<JsonNode> messagesOfJazzy() throws IOException {
    return lines("jazzy.jsonl");
  }

  private static List<JsonNode> lines(String name) throws IOException {
    try (Stream<String> lines = Files.lines(FOLDER.resolve(name))) {
      return lines.map(ConformanceTest::json).toList();
    }
  }

  private static JsonNode json(String text) {
    try {
      return JSON.readTree(text);
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void everyOwnTypeHasMessages() throws IOException {
    Set<String> tried = new TreeSet<>(CATALOG.ownNames());
    messages().forEach(line -> tried.remove(line.get("type").asText()));
    assertEquals(Set.of(), tried);
  }

  @ParameterizedTest
  @MethodSource("messages")
  void messagesHaveTheirBytes(JsonNode line) {
    MessageType type = CATALOG.find(line.get("type").asText()).orElseThrow();
    assertEquals(line.get("hash").asText(), type.hash());
    hasItsBytes(type, line);
  }

  @ParameterizedTest
  @MethodSource("messagesOfJazzy")
  void messagesOfJazzyHaveTheirBytes(JsonNode line) {
    MessageType type = JAZZY.find(line.get("type").asText()).orElseThrow();
    if (!OF_CHARACTERS.contains(type.name())) {
      assertEquals(line.get("hash").asText(), type.hash());
    }
    hasItsBytes(type, line);
  }

  @Test
  void everyTypeThatIsDifferentInJazzyHasMessages() throws IOException {
    Set<String> tried = new TreeSet<>();
    messagesOfJazzy().forEach(line -> tried.add(line.get("type").asText()));
    assertEquals(StandardTypes.different(RosDistribution.JAZZY), tried);
  }

  private static void hasItsBytes(MessageType type, JsonNode line) {
    MessageValue value = PlainMessages.read(type, line.get("value"));
    byte[] bytes = HexFormat.of().parseHex(line.get("cdr").asText());
    assertArrayEquals(bytes, CdrCodec.encode(value));
    assertEquals(value, CdrCodec.decode(type, bytes));
    byte[] bigEndian = HexFormat.of().parseHex(line.get("cdr_big_endian").asText());
    assertEquals(value, CdrCodec.decode(type, bigEndian));
  }

  static List<JsonNode> pairs() throws IOException {
    JsonNode pairs = JSON.readTree(FOLDER.resolve("qos.json").toFile());
    return StreamSupport.stream(pairs.spliterator(), false).toList();
  }

  @ParameterizedTest
  @MethodSource("pairs")
  void offersSatisfyRequestsOrNot(JsonNode pair) {
    QosSettings offered = settings(pair.get("offered"));
    QosSettings requested = settings(pair.get("requested"));
    List<String> found =
        QosSettings.incompatibilities(offered, requested).stream()
            .map(each -> each.policy().replace("lease duration", "liveliness"))
            .map(policy -> policy.toUpperCase(Locale.ROOT))
            .distinct()
            .toList();
    assertEquals(JSON.convertValue(pair.get("incompatible"), List.class), found);
  }

  private static QosSettings settings(JsonNode stated) {
    QosSettings settings =
        QosSettings.named(stated.path("profile").asText("default")).orElseThrow();
    if (stated.has("reliability")) {
      settings = settings.withReliability(kind(QosSettings.Reliability.class, stated));
    }
    if (stated.has("durability")) {
      settings = settings.withDurability(kind(QosSettings.Durability.class, stated));
    }
    if (stated.has("liveliness")) {
      settings = settings.withLiveliness(kind(QosSettings.Liveliness.class, stated));
    }
    if (stated.has("deadline_ns")) {
      settings = settings.withDeadline(Duration.ofNanos(stated.get("deadline_ns").asLong()));
    }
    if (stated.has("lease_ns")) {
      settings = settings.withLease(Duration.ofNanos(stated.get("lease_ns").asLong()));
    }
    return settings;
  }

  private static <E extends Enum<E>> E kind(Class<E> type, JsonNode stated) {
    return Enum.valueOf(type, stated.get(type.getSimpleName().toLowerCase(Locale.ROOT)).asText());
  }
}
