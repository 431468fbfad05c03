package dev.eventchain.messages;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.ExpectedFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class MessageCatalogTest {

  private static final Path FOLDERS = Path.of("src/test/resources/folders");
  private static final MessageCatalog STANDARD = MessageCatalog.of(List.of());
  private static final MessageCatalog JAZZY = MessageCatalog.of(RosDistribution.JAZZY, List.of());

  /** Hashes that nodes of ROS 2 Jazzy announce. */
  @ParameterizedTest
  @CsvSource({
    "sensor_msgs/msg/Range, b42b62562e93cbfe9d42b82fe5994dfa3d63d7d5c90a317981703f7388adff3a",
    "service_msgs/msg/ServiceEventInfo, 41bcbbe07a75c9b52bc96bfd5c24d7f0fc0a08c0cb7921b3373c5732345a6f45",
    "std_msgs/msg/String, df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"
  })
  void hashesOfJazzyAreThoseThatRosPublishes(String type, String hash) {
    assertEquals("RIHS01_" + hash, JAZZY.find(type).orElseThrow().hash());
  }

  @Test
  void definitionsOfJazzyReplaceThoseOfHumble() {
    assertEquals(150, STANDARD.names().size());
    assertEquals(162, JAZZY.names().size());
    assertTrue(JAZZY.names().containsAll(STANDARD.names()));
    assertEquals(Optional.empty(), STANDARD.find("geometry_msgs/VelocityStamped"));
    assertTrue(JAZZY.find("geometry_msgs/VelocityStamped").isPresent());
    assertNotEquals(
        STANDARD.find("sensor_msgs/Range").orElseThrow().hash(),
        JAZZY.find("sensor_msgs/Range").orElseThrow().hash());
    MessageType status = JAZZY.find("sensor_msgs/NavSatStatus").orElseThrow();
    assertEquals(-2, ((Number) MessageValue.of(status).get("status")).intValue());
    assertEquals("{}", STANDARD.ownDefinitions().strip());
  }

  @Test
  void aHintNamesTheReleaseThatHasATypeOrField() {
    String hint =
        "ROS 2 Jazzy has it, and the messages used here are those of Humble: see 'ros_distro' in eventchain.yaml. ";
    assertEquals(hint, STANDARD.hintOfDistribution("geometry_msgs/VelocityStamped", ""));
    assertEquals(hint, STANDARD.hintOfDistribution("sensor_msgs/msg/Range", "variance"));
    assertEquals("", STANDARD.hintOfDistribution("sensor_msgs/msg/Range", "variances"));
    assertEquals("", STANDARD.hintOfDistribution("geometry_msgs/VelocityStamp", ""));
    assertEquals("", JAZZY.hintOfDistribution("sensor_msgs/msg/Range", "varianc"));
  }

  static Stream<Path> folders() throws IOException {
    try (Stream<Path> folders = Files.list(FOLDERS)) {
      return folders.filter(Files::isDirectory).sorted().toList().stream();
    }
  }

  /** The expected findings of a folder are next to it; a missing file is written. */
  @ParameterizedTest
  @MethodSource("folders")
  void findingsAreAsExpected(Path folder) throws IOException {
    MessageCatalog catalog = MessageCatalog.of(List.of(folder));
    String actual = DiagnosticFormat.TEXT.render(catalog.diagnostics());
    ExpectedFile.check(folder.resolveSibling(folder.getFileName() + ".expected"), actual);
  }

  @Test
  void definitionIsReadWithDefaultsAndConstants() {
    MessageCatalog catalog = MessageCatalog.of(List.of(FOLDERS.resolve("message.syntax")));
    MessageType type = catalog.find("good_msgs/Good").orElseThrow();
    assertEquals(
        List.of(
            "std_msgs/msg/Header header",
            "geometry_msgs/msg/Vector3[2] positions",
            "float64[<=9] values",
            "string<=5[] names",
            "uint8 level",
            "bool on"),
        type.fields().stream().map(field -> field.type() + " " + field.name()).toList());
    assertEquals(
        List.of("int32 FIRST=1", "string TEXT=a = b"),
        type.constants().stream().map(c -> c.type() + " " + c.name() + "=" + c.value()).toList());
    MessageValue value = MessageValue.of(type);
    assertArrayEquals(new double[] {1.0, -2500.0}, (double[]) value.get("values"));
    assertEquals(List.of("a", "b"), value.get("names"));
    assertEquals(16, value.get("level"));
    assertEquals(true, value.get("on"));
    assertEquals(value, CdrCodec.decode(type, CdrCodec.encode(value)));
  }

  @Test
  void definitionInIdlIsReadWithDefaultsAndConstants() {
    MessageCatalog catalog = MessageCatalog.of(List.of(Path.of("conformance/definitions")));
    assertEquals(List.of(), catalog.diagnostics());
    MessageType type = catalog.find("radar_msgs/Target").orElseThrow();
    assertEquals(
        List.of(
            "std_msgs/msg/Header header",
            "float64 speed",
            "bool seen",
            "string<=20 name",
            "float64[9] covariance",
            "string[2] words",
            "geometry_msgs/msg/Vector3[3] corners",
            "byte[<=7] raw",
            "int16[] codes"),
        type.fields().stream().map(field -> field.type() + " " + field.name()).toList());
    assertEquals(
        List.of("LIMIT=-7", "MASK=31", "RANGE=150.0", "IS_NEW=true", "NAME=a name\n"),
        type.constants().stream().map(c -> c.name() + "=" + c.value()).toList());
    MessageValue value = MessageValue.of(type);
    assertEquals(-2.5, value.get("speed"));
    assertEquals(true, value.get("seen"));
    assertEquals("no \"name\"", value.get("name"));
    assertArrayEquals(new short[] {1, 2, 3}, (short[]) value.get("codes"));
    assertEquals(
        List.of(), catalog.find("radar_msgs/msg/Nothing").orElseThrow().fields(), "a placeholder");
  }

  @Test
  void recordingsHoldDefinitionsInIdlAsMessageDefinitions() {
    MessageCatalog catalog = MessageCatalog.of(List.of(Path.of("conformance/definitions")));
    String text = catalog.text(catalog.find("radar_msgs/msg/Scan").orElseThrow());
    assertTrue(text.startsWith("uint64 stamp\nuint64[2] stamps\nradar_msgs/Target nearest\n"));
    assertTrue(text.contains("MSG: radar_msgs/Target\nstd_msgs/Header header\nfloat64 speed\n"));
  }

  @Test
  void bothLanguagesMaySayTheSame(@TempDir Path folder) throws IOException {
    Path own = Files.createDirectories(folder.resolve("own_msgs/msg"));
    Files.writeString(own.resolve("Own.msg"), "char a\nfloat32[<=2] b [1, 2]\nint8 C=3\n");
    Files.writeString(
        own.resolve("Own.idl"),
        """
        module own_msgs { module msg {
          module Own_Constants { const int8 C = 3; };
          struct Own { uint8 a; @default(value="(1, 2)") sequence<float, 2> b; };
        }; };
        """);
    MessageCatalog catalog = MessageCatalog.of(List.of(folder));
    assertEquals(List.of(), catalog.diagnostics());
    assertEquals(
        "char a\nfloat32[<=2] b [1, 2]\nint8 C=3\n",
        catalog.text(catalog.find("own_msgs/Own").orElseThrow()));
  }

  @Test
  void usingABrokenDefinitionFailsWithItsFindings() {
    MessageCatalog catalog = MessageCatalog.of(List.of(FOLDERS.resolve("message.cycle")));
    DiagnosticException failure =
        assertThrows(DiagnosticException.class, () -> catalog.find("bad_msgs/msg/First"));
    assertEquals(DiagnosticException.Reason.INPUT, failure.reason());
    assertEquals("message.cycle", failure.diagnostics().get(0).id());
  }

  @Test
  void laterFolderHidesEarlierOnesAndStandardTypes(@TempDir Path folder) throws IOException {
    Path first = folder.resolve("first/std_msgs/msg");
    Path second = folder.resolve("second/std_msgs/msg");
    Files.createDirectories(first);
    Files.createDirectories(second);
    Files.writeString(first.resolve("Bool.msg"), "int8 first\n");
    Files.writeString(second.resolve("Bool.msg"), "int8 second\r\n");
    List<Path> folders = List.of(folder.resolve("first"), folder.resolve("second"));
    MessageType type = MessageCatalog.of(folders).find("std_msgs/Bool").orElseThrow();
    assertEquals("second", type.fields().get(0).name());
  }

  @Test
  void missingFolderIsReported(@TempDir Path folder) {
    List<Path> folders = List.of(folder.resolve("nowhere"));
    DiagnosticException failure =
        assertThrows(DiagnosticException.class, () -> MessageCatalog.of(folders));
    assertEquals("file.unreadable", failure.diagnostics().get(0).id());
  }

  /** A colcon workspace: packages at any depth, and what colcon passes over. */
  @Test
  void messagesOfAWorkspaceAreReadAtAnyDepth(@TempDir Path workspace) throws IOException {
    write(workspace.resolve("src/group/track/package.xml"), manifest("track_msgs"));
    write(workspace.resolve("src/group/track/msg/Track.msg"), "other_msgs/Other other\n");
    write(workspace.resolve("src/group/track/test/Fake.msg"), "int8 a\n");
    write(workspace.resolve("src/other_msgs/package.xml"), manifest("other_msgs"));
    write(workspace.resolve("src/other_msgs/msg/Other.msg"), "int8 a\n");
    Files.createSymbolicLink(workspace.resolve("src/group/again"), workspace.resolve("src"));
    for (String passed : List.of("old/COLCON_IGNORE", "older/AMENT_IGNORE", ".git/config")) {
      Path folder = workspace.resolve("src").resolve(passed).getParent();
      write(workspace.resolve("src").resolve(passed), "");
      write(folder.resolve("package.xml"), manifest("old_msgs"));
      write(folder.resolve("msg/Old.msg"), "no definition");
    }
    write(workspace.resolve("install/track_msgs/share/track_msgs/package.xml"), manifest("a_msgs"));
    write(workspace.resolve("install/track_msgs/share/track_msgs/msg/Track.msg"), "int8 b\n");
    write(workspace.resolve("build/x/package.xml"), "no manifest");
    MessageCatalog catalog = MessageCatalog.of(List.of(workspace));
    assertEquals(Set.of("other_msgs/msg/Other", "track_msgs/msg/Track"), catalog.ownNames());
    assertEquals(
        List.of(workspace.resolve("src/group/track/test/Fake.msg").toString()),
        catalog.diagnostics().stream().map(it -> it.location().file()).toList());
    assertTrue(
        catalog.find("track_msgs/Track").orElseThrow().resolve("other.a").type().isPresent());
  }

  /** Without a readable manifest, a folder is what its name says, or nothing. */
  @ParameterizedTest
  @ValueSource(strings = {"", "<package>", "<package><name>No Name</name></package>", "\0\1"})
  void aBrokenManifestNamesNoPackage(String text, @TempDir Path folder) throws IOException {
    write(folder.resolve("src/track/package.xml"), text);
    write(folder.resolve("src/track/msg/Track.msg"), "int8 a\n");
    write(folder.resolve("other/package.xml"), text);
    write(folder.resolve("other/msg/Other.msg"), "int8 a\n");
    MessageCatalog catalog = MessageCatalog.of(List.of(folder));
    assertEquals(Set.of("other/msg/Other"), catalog.ownNames());
    assertEquals(1, catalog.diagnostics().size());
  }

  /** Two packages of one name are one, unless they contradict each other. */
  @Test
  void packagesOfOneNameMustNotContradict(@TempDir Path folder) throws IOException {
    for (String name : List.of("first", "second")) {
      write(folder.resolve(name + "/package.xml"), manifest("track_msgs"));
      write(folder.resolve(name + "/msg/Track.msg"), "int8 " + name + "\n");
    }
    String found = DiagnosticFormat.TEXT.render(MessageCatalog.of(List.of(folder)).diagnostics());
    assertTrue(
        found.contains("second/msg/Track.msg defines track_msgs/msg/Track differently"), found);
  }

  private static String manifest(String name) {
    return "<?xml version='1.0'?>\n<package format='3'>\n <name>" + name + "</name>\n</package>\n";
  }

  private static void write(Path file, String text) throws IOException {
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }

  @Test
  void unknownTypeIsEmpty() {
    assertEquals(Optional.empty(), STANDARD.find("sensor_msgs/msg/LaserScanner"));
    assertEquals(Optional.empty(), STANDARD.find("LaserScan"));
    assertEquals(Optional.empty(), STANDARD.find(""));
  }

  @Test
  void quaternionStartsAsNoRotation() {
    MessageValue pose = MessageValue.of(STANDARD.find("geometry_msgs/Pose").orElseThrow());
    assertEquals(1.0, pose.get("orientation.w"));
    assertEquals(0.0, pose.get("orientation.x"));
  }

  @ParameterizedTest
  @CsvSource({
    "nav_msgs/Odometry, twist.twist.linear.x, float64",
    "nav_msgs/Odometry, pose.covariance, float64[36]",
    "sensor_msgs/LaserScan, ranges, float32[]",
    "sensor_msgs/LaserScan, header.stamp.nanosec, uint32",
    "sensor_msgs/PointCloud2, fields, sensor_msgs/msg/PointField[]",
    "std_msgs/String, data, string"
  })
  void pathLeadsToItsType(String type, String path, String expected) {
    MessageType.Resolution found = STANDARD.find(type).orElseThrow().resolve(path);
    assertEquals(expected, found.type().orElseThrow().toString());
    assertEquals("", found.problem());
  }

  @ParameterizedTest
  @CsvSource({
    "nav_msgs/Odometry, twist.linear.x, has no field 'linear'; it has twist",
    "nav_msgs/Odometry, twist.twist.linear.x.y, 'x' of geometry_msgs/msg/Vector3 is float64",
    "sensor_msgs/PointCloud2, fields.name, is sensor_msgs/msg/PointField[]",
    "sensor_msgs/LaserScan, '', has no field ''",
    "sensor_msgs/LaserScan, ranges., 'ranges' of sensor_msgs/msg/LaserScan is float32[]",
    "std_msgs/Empty, data, it has none"
  })
  void wrongPathSaysWhereItIsWrong(String type, String path, String problem) {
    MessageType.Resolution found = STANDARD.find(type).orElseThrow().resolve(path);
    assertTrue(found.type().isEmpty());
    assertTrue(found.problem().contains(problem), found.problem());
  }

  @ParameterizedTest
  @CsvSource({
    "nav_msgs/Odometry, twist.linear.x, Did you mean `twist.twist.linear.x`?",
    "nav_msgs/Odometry, twist.twist.liner.x, Did you mean `twist.twist.linear.x`?",
    "nav_msgs/Odometry, twst.linear.x, Did you mean `twist`?",
    "nav_msgs/Odometry, nothing.like.it, ''",
    "sensor_msgs/PointCloud2, fields.name, Name the whole field: fields.",
    "sensor_msgs/LaserScan, header.stamp.sec.x, Name the whole field: header.stamp.sec.",
    "sensor_msgs/LaserScan, ranges[0], 'Name the whole field, ranges, and pick the value"
        + " inside the component.'",
  })
  void wrongPathSaysWhatWasMeant(String type, String path, String hint) {
    assertEquals(hint, STANDARD.find(type).orElseThrow().resolve(path).hint());
  }

  @ParameterizedTest
  @CsvSource({
    "ranges, 1",
    "header.seq, 1",
    "header, 1",
    "header.stamp.sec, 2147483648",
    "header.stamp.sec, 0.5",
    "header.frame_id, 1",
    "angle_min.x, 1"
  })
  void valuesThatDoNotFitAreRefused(String path, double value) {
    MessageValue scan = MessageValue.of(STANDARD.find("sensor_msgs/LaserScan").orElseThrow());
    assertThrows(IllegalArgumentException.class, () -> scan.set(path, value));
    assertEquals(MessageValue.of(scan.type()), scan);
  }

  @Test
  void numbersAreReadAsTheyAreMeant() {
    MessageValue value = MessageValue.of(STANDARD.find("std_msgs/UInt64").orElseThrow());
    value.set("data", new java.math.BigInteger("18446744073709551615"));
    assertEquals(0x1p64, value.number("data"));
    assertThrows(IllegalArgumentException.class, () -> value.set("data", -1));
    assertThrows(IllegalArgumentException.class, () -> value.number("other"));
    assertThrows(IllegalArgumentException.class, () -> value.forEachNumber("data", it -> {}));
  }

  @ParameterizedTest
  @CsvSource({"UInt8, 255", "UInt16, 65535", "UInt32, 4294967295", "Int16, -5", "Float32, 0.5"})
  void elementsAreReadAsTheyAreMeant(String kind, double element) {
    MessageValue value =
        MessageValue.of(STANDARD.find("std_msgs/%sMultiArray".formatted(kind)).orElseThrow());
    value.set("data", List.of(element, 0.0));
    List<Double> numbers = new ArrayList<>();
    value.forEachNumber("data", numbers::add);
    assertEquals(List.of(element, 0.0), numbers);
    assertThrows(
        IllegalArgumentException.class, () -> value.forEachNumber("layout.dim", numbers::add));
  }

  @Test
  void wstringIsRefusedWhereItIsDefined(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("my_msgs/msg/Wide.msg");
    Files.createDirectories(file.getParent());
    Files.writeString(file, "int8 a\nwstring<=4 text \"a\"\n");
    List<Diagnostic> found = MessageCatalog.of(List.of(folder)).diagnostics();
    assertEquals(List.of("message.syntax"), found.stream().map(Diagnostic::id).toList());
    assertEquals(2, found.get(0).location().line());
  }

  @Test
  void keywordsAreThoseOfPython() throws Exception {
    Process python =
        new ProcessBuilder("python3", "-c", "import keyword; print('\\n'.join(keyword.kwlist))")
            .redirectErrorStream(true)
            .start();
    String output = new String(python.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, python.waitFor(), output);
    assertEquals(output.lines().toList(), MemberNames.keywords());
  }

  @Test
  void messagesDoNotShareWhatTheyHold() {
    MessageType type = STANDARD.find("nav_msgs/Odometry").orElseThrow();
    MessageValue first = MessageValue.of(type).set("pose.pose.position.x", 1);
    assertFalse(first.equals(MessageValue.of(type)));
    assertEquals(0.0, MessageValue.of(type).number("pose.pose.position.x"));
  }
}
