package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.yaml.snakeyaml.Yaml;

/** Runs the commands of the matrices for build servers, as those would. */
class CampaignMatrixTest {

  private static final Path FOLDER = Program.ROOT.resolve("bundles/front/ci");
  private static final String COMMAND = "\"$EVENTCHAIN\" campaign";

  /**
   * The commands of a file.
   *
   * @param part the command of each part
   * @param parts the variables of each part
   * @param all the command that puts the parts together
   */
  private record Matrix(
      String part, List<Map<String, String>> parts, String all, Map<String, String> common) {}

  @TempDir Path folder;

  private static List<String> services() {
    return Thorough.allOrOne(List.of("github", "gitlab"));
  }

  @InTurn
  @ParameterizedTest
  @MethodSource("services")
  void theCommandsOfAMatrixComeToTheWholeCampaign(String service) throws Exception {
    Matrix matrix = service.equals("github") ? github() : gitlab();
    assertEquals(3, matrix.parts().size());
    ProjectCopy copy = ProjectCopy.of("radar-aeb", folder);
    copy.endAtEightSeconds();
    Files.move(copy.path(), folder.resolve(matrix.common().get("PROJECT")));
    Path campaign = folder.resolve(matrix.common().get("CAMPAIGN"));
    Files.createDirectories(campaign.getParent());
    Files.writeString(
        campaign,
        """
        scenario: stopped-vehicle-50
        factors: {gap: {path: "actors[0].gap_m", values: [10, 40, 50, 60]}}
        """);
    // In the same words, since the page has commands.
    String undivided = COMMAND + " \"$PROJECT\" \"$CAMPAIGN\" -o out";
    assertEquals(1, run(undivided, matrix.common(), Map.of()), "one case fails");
    Path whole = Files.move(folder.resolve("out"), folder.resolve("whole"));
    for (Map<String, String> part : matrix.parts()) {
      assertEquals(0, run(matrix.part(), matrix.common(), part));
    }
    keepArtifacts();
    assertEquals(1, run(matrix.all(), matrix.common(), Map.of()));
    for (String name : List.of("cases.csv", "cases.json", "report.html")) {
      assertArrayEquals(
          Files.readAllBytes(whole.resolve("campaigns/approach").resolve(name)),
          Files.readAllBytes(folder.resolve("out/campaigns/approach").resolve(name)),
          name);
    }
    assertTrue(Files.readString(folder.resolve("campaign.xml")).contains("tests=\"4\""));
  }

  /** Both services keep the same: {@code cases.json} of each part, in its folder. */
  @Test
  void theArtifactsOfPartsAreTheirCases() throws Exception {
    for (String service : List.of("github", "gitlab")) {
      String text = Files.readString(FOLDER.resolve("campaign-" + service + ".yml"));
      assertTrue(text.contains(" parts/*/campaigns/*/cases.json"), service);
    }
  }

  /** Removes what the next job would not have. */
  private void keepArtifacts() throws IOException {
    try (Stream<Path> files = Files.walk(folder.resolve("parts"))) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        if (!file.endsWith("cases.json")) {
          Files.delete(file);
        }
      }
    }
  }

  private int run(String command, Map<String, String> common, Map<String, String> own)
      throws Exception {
    Path program = folder.resolve("program");
    Files.writeString(program, new Program().script());
    assertTrue(program.toFile().setExecutable(true));
    ProcessBuilder builder = new ProcessBuilder("bash", "-e", "-c", command);
    builder.environment().putAll(common);
    builder.environment().putAll(own);
    builder.environment().put("EVENTCHAIN", program.toString());
    builder.directory(folder.toFile()).redirectErrorStream(true);
    return builder.redirectOutput(folder.resolve("log").toFile()).start().waitFor();
  }

  private static Matrix github() throws IOException {
    Map<?, ?> file = read("campaign-github.yml");
    Map<?, ?> part = in(file, "jobs", "part");
    List<Map<String, String>> parts = new ArrayList<>();
    List<?> numbers = (List<?>) in(part, "strategy", "matrix").get("part");
    for (Object number : numbers) {
      Map<String, String> variables = new TreeMap<>();
      in(part, "env")
          .forEach(
              (name, value) ->
                  variables.put(
                      name.toString(),
                      value
                          .toString()
                          .replace("${{ matrix.part }}", number.toString())
                          .replace("${{ strategy.job-total }}", "" + numbers.size())));
      parts.add(variables);
    }
    return new Matrix(
        command((List<?>) part.get("steps")),
        parts,
        command((List<?>) in(file, "jobs", "all").get("steps")),
        texts(in(file, "env")));
  }

  private static Matrix gitlab() throws IOException {
    Map<?, ?> file = read("campaign-gitlab.yml");
    List<Map<String, String>> parts = new ArrayList<>();
    int count = (Integer) in(file, "campaign-part").get("parallel");
    for (int index = 1; index <= count; index++) {
      parts.add(Map.of("CI_NODE_INDEX", "" + index, "CI_NODE_TOTAL", "" + count));
    }
    return new Matrix(
        command((List<?>) in(file, "campaign-part").get("script")),
        parts,
        command((List<?>) in(file, "campaign").get("script")),
        texts(in(file, ".campaign", "variables")));
  }

  /** Returns the only command of the program among steps. */
  private static String command(List<?> steps) {
    List<String> commands =
        steps.stream()
            .map(step -> step instanceof Map<?, ?> each ? each.get("run") : step)
            .filter(text -> text != null && text.toString().startsWith(COMMAND))
            .map(Object::toString)
            .toList();
    assertEquals(1, commands.size(), commands.toString());
    return commands.get(0);
  }

  private static Map<?, ?> read(String name) throws IOException {
    return new Yaml().load(Files.readString(FOLDER.resolve(name)));
  }

  private static Map<?, ?> in(Map<?, ?> map, String... keys) {
    Map<?, ?> inner = map;
    for (String key : keys) {
      inner = (Map<?, ?>) inner.get(key);
    }
    return inner;
  }

  private static Map<String, String> texts(Map<?, ?> map) {
    Map<String, String> texts = new TreeMap<>();
    map.forEach((name, value) -> texts.put(name.toString(), value.toString()));
    return texts;
  }
}
