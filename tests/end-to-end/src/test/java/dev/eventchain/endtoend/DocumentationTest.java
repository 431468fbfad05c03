package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Tests that the commands on the pages for users work as documented. Bash runs {@code console}
 * blocks, page by page in one folder; {@code ...} in their output stands for anything. Only the
 * first run of the tutorial measures the strength of requirements, since nothing else shows it.
 */
class DocumentationTest {

  private static final Path PAGES = Program.ROOT.resolve("bundles/documentation/src/site");

  private static final Pattern BLOCK =
      Pattern.compile("(?ms)^```console(?: exit=(\\d+))?\\n(.*?)^```$");

  private static final Pattern YAML = Pattern.compile("(?ms)^```yaml\\n(.*?)^```$");

  @TempDir Path folder;

  /** A command and its output. */
  private record Step(String command, String printed) {}

  @BeforeEach
  void installWithoutStrength() throws IOException {
    install("[ \"$1\" != run ] || set -- \"$@\" --no-strength\n");
  }

  /** Installs the program, started by a shell script that begins with these lines. */
  private void install(String before) throws IOException {
    Path bin = Files.createDirectories(folder.resolve("bin"));
    Path program = bin.resolve("eventchain");
    Files.writeString(program, new Program().script().replace("\nexec", "\n" + before + "exec"));
    assertTrue(program.toFile().setExecutable(true));
  }

  @Test
  void theTutorial() throws Exception {
    install(
        "[ \"$1\" != run ] || [ ! -e \"$2/out/verdict.json\" ] || set -- \"$@\" --no-strength\n");
    assertTrue(run("tutorial.md") >= 6);
  }

  @ParameterizedTest
  @MethodSource
  void others(String pages) throws Exception {
    for (String page : pages.split(" ", -1)) {
      assertTrue(run(page) >= 1, page);
    }
  }

  /** Returns pages; those of one line go on in one folder. */
  static List<String> others() {
    return Thorough.allOrOne(
        List.of(
            "build-server.md",
            "campaigns.md",
            "constraints.md templates.md diagrams.md",
            "formats.md",
            "projects.md",
            "requirements.md",
            "ros2-workspaces.md",
            "simulation.md"));
  }

  @InTurn
  @Test
  void settingsOfLanguageModelsAreRead() throws Exception {
    run(new Step("eventchain init my-project\n", "...\n"), 0);
    Path settings = folder.resolve("my-project/eventchain.yaml");
    String written = Files.readString(settings);
    Matcher block = YAML.matcher(Files.readString(PAGES.resolve("language-models.md")));
    Step validate = new Step("eventchain validate my-project\n", "...\n");
    int blocks = 0;
    for (; block.find(); blocks++) {
      String text = block.group(1);
      Files.writeString(settings, text.startsWith("name:") ? text : written + text);
      run(validate, 0);
      Files.writeString(settings, "modles: {}\n", StandardOpenOption.APPEND);
      run(validate, 2);
    }
    assertEquals(2, blocks);
  }

  /** A page without a test above would not be noticed otherwise. */
  @Test
  void noOtherPageHasCommands() throws IOException {
    try (var pages = Files.list(PAGES)) {
      List<String> with = new ArrayList<>();
      for (Path page : pages.sorted().toList()) {
        if (BLOCK.matcher(Files.readString(page)).find()) {
          with.add(page.getFileName().toString());
        }
      }
      assertEquals(
          List.of(
              "build-server.md",
              "campaigns.md",
              "constraints.md",
              "diagrams.md",
              "formats.md",
              "projects.md",
              "requirements.md",
              "ros2-workspaces.md",
              "simulation.md",
              "templates.md",
              "tutorial.md"),
          with);
    }
  }

  /** Runs a page and returns its number of blocks. */
  private int run(String page) throws Exception {
    Matcher block = BLOCK.matcher(Files.readString(PAGES.resolve(page)));
    int blocks = 0;
    while (block.find()) {
      blocks++;
      List<Step> steps = steps(block.group(2));
      int last = block.group(1) == null ? 0 : Integer.parseInt(block.group(1));
      for (int i = 0; i < steps.size(); i++) {
        run(steps.get(i), i + 1 < steps.size() ? 0 : last);
      }
    }
    return blocks;
  }

  private void run(Step step, int expected) throws Exception {
    Path out = folder.resolve("printed");
    ProcessBuilder builder = new ProcessBuilder("bash", "-c", step.command());
    builder.directory(folder.toFile()).redirectErrorStream(true).redirectOutput(out.toFile());
    builder.environment().merge("PATH", folder.resolve("bin") + ":", (path, bin) -> bin + path);
    int code = builder.start().waitFor();
    String printed = Files.readString(out);
    assertEquals(expected, code, () -> step.command() + "\n" + printed);
    String pattern =
        Pattern.compile("\\.\\.\\.\\n?")
            .splitAsStream(step.printed())
            .map(Pattern::quote)
            .collect(
                Collectors.joining(
                    "(?s:.*)", "", step.printed().endsWith("...\n") ? "(?s:.*)" : ""));
    assertTrue(
        printed.matches(pattern), () -> step.command() + "\n" + printed + "\nnot\n" + pattern);
  }

  private static List<Step> steps(String block) {
    List<Step> steps = new ArrayList<>();
    for (String line : block.lines().toList()) {
      if (line.startsWith("$ ")) {
        steps.add(new Step(line.substring(2) + "\n", ""));
        continue;
      }
      Step latest = steps.remove(steps.size() - 1);
      steps.add(
          line.equals(">") || line.startsWith("> ")
              ? new Step(latest.command() + line.replaceFirst("> ?", "") + "\n", latest.printed())
              : new Step(latest.command(), latest.printed() + line + "\n"));
    }
    return steps;
  }
}
