package dev.eventchain.m2t;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * What {@code templates/ros2-python} writes is a package that works: executed with the tools and
 * the runtime of the project, since ROS 2 itself is not needed here.
 */
class GeneratedPackageTest {
  private static final Path ROOT = Path.of("../../..").toAbsolutePath().normalize();
  private static final Path RESOURCES = Path.of("src/test/resources").toAbsolutePath();
  private static final Path RUNTIME = ROOT.resolve("bundles/robot/runtime");
  private static final String ENVIRONMENT =
      "bundles/robot/sandbox/src/main/resources/dev/eventchain/sandbox/environment.py";

  private static final Map<String, Map<String, byte[]>> GENERATED = new HashMap<>();

  @TempDir Path temporary;

  /** How a command ended. */
  private record Ended(int code, String output) {
    String expect(int expected) {
      assertEquals(expected, code, output);
      return output;
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"aeb", "fork-and-join", "hostile", "names", "topics"})
  void theLinterFindsNothing(String name) throws Exception {
    Path folder = write(name);
    for (List<String> settings :
        List.of(List.of("--isolated"), List.of("--config", ROOT.resolve("ruff.toml").toString()))) {
      List<String> check = ruff("check", settings);
      // Ament and this project want docstrings of several lines to begin differently.
      check.addAll(List.of("--extend-ignore", "D212"));
      python(folder, check).expect(0);
      List<String> format = ruff("format", settings);
      format.addAll(List.of("--check", "--diff"));
      python(folder, format).expect(0);
    }
  }

  /** Names of 64 characters, topics and units of several lines, fields inside fields. */
  @ParameterizedTest
  @ValueSource(strings = {"aeb", "fork-and-join", "hostile", "long", "names", "topics"})
  void linesAreAsShortAsAmentWantsAndFunctionsHaveTypes(String name) throws Exception {
    Path folder = write(name);
    List<String> ament = List.of("--isolated", "--line-length", "99");
    List<String> check = ruff("check", ament);
    // Any is what components exchange; the others are those that ament_flake8 and ament_pep257
    // leave out, and the names of modules, which are the model's.
    check.addAll(List.of("--select", "A,C4,D,E,F,W,I,UP,ANN,RUF"));
    check.addAll(List.of("--ignore", "ANN401,A005,D1,D203,D212,D404"));
    python(folder, check).expect(0);
    List<String> format = ruff("format", ament);
    format.addAll(List.of("--check", "--diff"));
    python(folder, format).expect(0);
  }

  @ParameterizedTest
  @ValueSource(strings = {"aeb", "fork-and-join", "long", "names", "topics"})
  void thePackageNamesWhatItImports(String name) throws Exception {
    String script = RESOURCES.resolve("packages/dependencies.py").toString();
    String missing = python(write(name), List.of(script, ".")).expect(0);
    assertEquals("[]", missing.strip());
  }

  private static List<String> ruff(String command, List<String> settings) {
    List<String> words = new ArrayList<>(List.of("-m", "ruff", command, "--no-cache"));
    words.addAll(settings);
    words.add(".");
    return words;
  }

  /** Without ament they are skipped, which {@link #itsOwnTestsPass} sees. */
  @Test
  void amentIsAskedForTheStyle() throws Exception {
    Path folder = writeComplete("aeb");
    for (String linter : List.of("copyright", "flake8", "pep257")) {
      Path module = Files.createDirectory(folder.resolve("ament_" + linter)).resolve("main.py");
      Files.writeString(
          module,
          """
          def main(argv):
              print("ARGUMENTS", argv)
              return 0


          def main_with_errors(argv):
              return main(argv), []
          """);
    }
    String output =
        test(folder, "-s", "test/test_copyright.py", "test/test_flake8.py", "test/test_pep257.py")
            .expect(0);
    assertTrue(output.contains("2 passed, 1 skipped"), output);
    assertTrue(output.contains("ARGUMENTS ['--config', 'setup.cfg']"), output);
    assertTrue(output.contains("ARGUMENTS ['.', 'test', '--exclude', 'aeb/components/"), output);
  }

  @Test
  void nodesAreCalledInSnakeCase() throws Exception {
    Path folder = write("aeb");
    assertTrue(
        Files.readString(folder.resolve("aeb/ttc_calculation_node.py"))
            .contains("super().__init__(\"ttc_calculation\", **options)"));
    assertTrue(
        Files.readString(folder.resolve("config/aeb.yaml")).contains("\nttc_calculation:\n"));
    assertTrue(
        Files.readString(folder.resolve("launch/aeb.launch.py"))
            .contains("name=\"ttc_calculation\""));
  }

  @ParameterizedTest
  @CsvSource({"aeb, 39", "fork-and-join, 53", "long, 28", "topics, 32"})
  void itsOwnTestsPass(String name, int number) throws Exception {
    Path folder = writeComplete(name);
    String output = test(folder).expect(0);
    assertTrue(output.contains(" " + number + " passed"), output);
    assertTrue(output.contains("test_chain.py"), output);
  }

  /** A wrong node, constructed or connected as no model says, is what the tests are there for. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "ttc_calculation | \"/scan\" | \"/scam\" | test_ttc",
        "ttc_calculation | message.velocity | message.control.gear | test_ttc",
        "ttc_calculation | message.header.stamp.sec | message.header.stamp.nanosec | test_ttc",
        "ttc_calculation | received[\"ranges\"] = message | received[\"ego_speed\"] = message | test_ttc",
        "ttc_calculation | std_msgs.msg.Float32 | std_msgs.msg.Float64 | test_ttc",
        "ttc_calculation | float(output[\"ttc\"]) | float(output[\"ttc\"]) + 1.0 | test_ttc",
        "ttc_calculation | ReliabilityPolicy.BEST_EFFORT | ReliabilityPolicy.RELIABLE | test_ttc",
        "ttc_calculation | depth=1 | depth=2 | test_ttc",
        "ttc_calculation | from_value=0.000001 | from_value=-2.0 | test_ttc",
        "ttc_calculation | 1.0 / frequency | 1.0 / 20.0 | test_ttc",
        "ttc_calculation | < 3 | < 2 | test_ttc",
        "braking_decision | ReliabilityPolicy.RELIABLE | ReliabilityPolicy.BEST_EFFORT | test_chain",
        "braking_decision | std_msgs.msg.Float32 | std_msgs.msg.Float64 | test_chain"
      })
  void itsTestsNoticeAMistake(String node, String right, String wrong, String noticedBy)
      throws Exception {
    notices("aeb", node, right, wrong, noticedBy);
  }

  /** What the test itself sends does not stand in for what the node publishes on the same topic. */
  @ParameterizedTest
  @CsvSource({
    "self.publisher_level.publish(message), pass, are_published",
    "self.publisher_valid.publish(message), pass, are_published",
    "'float(output[\"next\"])', 'self.received[\"level\"]', are_published",
    "self.on_a_b__2, self.on_a_b__1, gets_what_was_sent",
    "self.on_a_b_2__4, self.on_a_b_2__3, gets_what_was_sent"
  })
  void itsTestsTellTopicsApart(String right, String wrong, String noticedBy) throws Exception {
    notices("topics", "frequency", right, wrong, noticedBy);
  }

  private void notices(String name, String node, String right, String wrong, String noticedBy)
      throws Exception {
    Path folder = writeComplete(name);
    Path module = folder.resolve(folder.getFileName()).resolve(node + "_node.py");
    String text = Files.readString(module);
    assertTrue(text.contains(right), right);
    Files.writeString(module, text.replace(right, wrong));
    Ended ended = test(folder, "-k", noticedBy);
    assertEquals(1, ended.code(), ended.output());
    assertTrue(ended.output().matches("(?s).*\\d+ failed.*"), ended.output());
  }

  /** Tests must neither be heard by the nodes of a vehicle nor hear them. */
  @Test
  void itsTestsKeepToThemselves() throws Exception {
    Path folder = writeComplete("topics");
    String isolation = RESOURCES.resolve("packages/test_isolation.py").toString();
    Files.copy(Path.of(isolation), folder.resolve("test/test_isolation.py"));
    test(folder, "-k", "isolation").expect(0);
  }

  @Test
  void theLaunchFileStartsEveryNodeWithTheParameters() throws Exception {
    Path folder = write("fork-and-join");
    String recorded =
        python(
                folder,
                List.of(
                    RESOURCES.resolve("packages/launch_recorder.py").toString(),
                    "launch/lane_fusion.launch.py"))
            .expect(0);
    for (String name : List.of("camera", "lane_detection", "vehicle_detection", "steering")) {
      assertTrue(recorded.contains("\"name\": \"" + name + "\""), recorded);
      assertTrue(
          recorded.contains("\"package\": \"lane_fusion\", \"executable\": \"" + name + "_node\""),
          recorded);
    }
    assertEquals(5, recorded.split("\\{\"class\": \"Node\"", -1).length, recorded);
    assertFalse(recorded.contains("{\"use_sim_time\": "), recorded);
  }

  /** Else a file with parameters could not say where time comes from. */
  @ParameterizedTest
  @CsvSource({"true, true", "True, true", "false, false", "False, false"})
  void theLaunchFileStatesTheTimeIfItIsGiven(String given, String stated) throws Exception {
    String recorder = RESOURCES.resolve("packages/launch_recorder.py").toString();
    String recorded =
        python(
                write("fork-and-join"),
                List.of(recorder, "launch/lane_fusion.launch.py", "use_sim_time:=" + given))
            .expect(0);
    assertTrue(recorded.contains("\"" + given + "\""), recorded);
    String parameters =
        "\"parameters\": [{\"class\": \"LaunchConfiguration\", \"name\": \"parameters\"},"
            + " {\"use_sim_time\": %s}]".formatted(stated);
    assertEquals(5, recorded.split(Pattern.quote(parameters), -1).length, recorded);
  }

  @Test
  void aValueTravelsThroughBothBranchesToTheJoin() throws Exception {
    Path folder = write("fork-and-join");
    components("fork-and-join", folder.resolve("lane_fusion/components"));
    String travel = RESOURCES.resolve("packages/fork-and-join/travel.py").toString();
    String output = python(folder, List.of(travel, folder.toString())).expect(0);
    // 8 m: 2 * 8 + 1 by the lane, 0.25 * 20 by the vehicle and 100 since it is urgent; 4 m: 9 +
    // 2.5.
    String last = output.lines().filter(line -> line.startsWith("{")).findFirst().orElseThrow();
    assertEquals("{\"warnings\": [], \"angles\": [122.0, 11.5]}", last, output);
  }

  private static void components(String name, Path target) throws IOException {
    try (Stream<Path> all = Files.list(RESOURCES.resolve("packages/" + name + "/components"))) {
      for (Path file : all.toList()) {
        Files.write(target.resolve(file.getFileName()), Files.readAllBytes(file));
      }
    }
  }

  /** Writes the package of a case; its folder. */
  private Path write(String name) throws IOException {
    String packageFolder = "";
    for (Map.Entry<String, byte[]> file : generated(name).entrySet()) {
      Path target = temporary.resolve(file.getKey());
      Files.createDirectories(target.getParent());
      Files.write(target, file.getValue());
      packageFolder = file.getKey().substring(0, file.getKey().indexOf('/'));
    }
    assertNotEquals("", packageFolder);
    return temporary.resolve(packageFolder);
  }

  /** Generates a case once: compiling the templates takes longer than all else. */
  private static Map<String, byte[]> generated(String name) throws IOException {
    if (!GENERATED.containsKey(name)) {
      Path folder = RESOURCES.resolve("cases/ros2-python").resolve(name);
      GENERATED.put(name, new TemplateCase(folder).run().files());
    }
    return GENERATED.get(name);
  }

  /** Writes the package of a case with components that do nothing; its folder. */
  private Path writeComplete(String name) throws IOException {
    Path folder = write(name);
    Path modules = folder.resolve(folder.getFileName());
    try (Stream<Path> all = Files.list(modules)) {
      for (Path node : all.filter(f -> f.toString().endsWith("_node.py")).toList()) {
        String component =
            Files.readString(node).replaceAll("(?s).*components\\.(\\w+) import.*", "$1");
        String text = "\"\"\"Does nothing.\"\"\"\n\n\nclass " + component + ":\n    pass\n";
        Files.writeString(modules.resolve("components/" + component + ".py"), text);
      }
    }
    return folder;
  }

  private Ended test(Path folder, String... arguments) throws Exception {
    List<String> words =
        new ArrayList<>(
            List.of(
                "-m", "pytest", "-p", "no:cacheprovider", "-p", "eventchain_ros2.pytest_plugin"));
    words.add("--messages=" + ROOT.resolve("bundles/robot/messages/conformance/definitions.json"));
    words.add("--messages=" + RESOURCES.resolve("packages/long/messages.json"));
    words.addAll(Arrays.asList(arguments));
    return python(folder, words);
  }

  private static Ended python(Path folder, List<String> arguments) throws Exception {
    List<String> command =
        new ArrayList<>(
            List.of("python3", ROOT.resolve(ENVIRONMENT).toString(), "--development", "--run"));
    command.addAll(arguments);
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    builder.environment().put("PYTHONPATH", RUNTIME + "/python:" + RUNTIME + "/tests");
    builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
    Process process = builder.redirectErrorStream(true).start();
    String output = new String(process.getInputStream().readAllBytes(), UTF_8);
    return new Ended(process.waitFor(), output);
  }
}
