package dev.eventchain.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.cli.Main;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.commonmark.node.Node;
import org.commonmark.parser.Parser;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;
import picocli.CommandLine.MissingParameterException;
import picocli.CommandLine.ParameterException;

/** Tests that the project's Markdown names only existing commands and options. */
class MarkdownCommandsTest {

  /** The changelog, which may name commands of earlier versions. */
  private static final Path HISTORY = Path.of("CHANGELOG.md");

  /** Files that also name options of other programs. */
  private static final Map<String, String> OTHER_PROGRAMS =
      Map.of("bundles/front/ci/README.md", "bundles/front/ci/validate-models");

  private static final CommandLine PROGRAM =
      Main.commandLine().setCaseInsensitiveEnumValuesAllowed(true);

  private static final Set<String> OPTIONS = new HashSet<>();

  static {
    PROGRAM.getSubcommands().values().forEach(command -> OPTIONS.addAll(optionsOf(command)));
  }

  @Test
  void everyCommandIsOne() throws IOException {
    List<String> problems = new ArrayList<>();
    int calls = 0;
    int spans = 0;
    for (Map.Entry<Path, Node> file : MarkdownFiles.in(MarkdownFiles.ROOT).entrySet()) {
      if (!file.getKey().equals(HISTORY)) {
        WrittenCommands written = new WrittenCommands(file.getValue());
        calls += written.calls().size();
        spans += written.spans().size();
        String others = otherProgram(file.getKey());
        for (String problem : problemsOf(written, others)) {
          problems.add(file.getKey() + ": " + problem);
        }
      }
    }
    assertEquals(List.of(), problems);
    assertTrue(calls > 60 && spans > 1000, calls + " calls, " + spans + " spans");
  }

  /** Each page about commands has some that are found. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "README.md",
        "CONTRIBUTING.md",
        "examples/aeb/README.md",
        "bundles/mde/m2t/ACCELEO.md",
        "bundles/documentation/src/site/tutorial.md",
        "bundles/run/pipeline/rules/project.stage.outdated.md"
      })
  void commandsAreFound(String file) throws IOException {
    Path path = MarkdownFiles.ROOT.resolve(file);
    Node document = Parser.builder().build().parse(Files.readString(path));
    assertTrue(!new WrittenCommands(document).calls().isEmpty());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          `./eventchain run DIR --llm 'command:PROGRAM ARGUMENTS'`          |
          `eventchain run DIR --to STAGE`                                   |
          `eventchain generate --template`                                  |
          `--driver dds`                                                    |
          `eventchain walk DIR`                                             | Unmatched argument
          `eventchain run DIR --fast`                                       | --fast
          `eventchain run DIR --driver ddt`                                 | Invalid value for option '--driver'
          `eventchain run DIR; bin/eventchain init --template X`            | --template
          `run --fast` is faster                                            | --fast
          `--fast` is faster                                                | --fast
          """)
  void whatIsNoCommandIsFound(String text, String expected) {
    assertProblem(expected, text);
  }

  @Test
  void blocksHoldCompleteCommands() {
    assertProblem(null, "```console\n$ eventchain run DIR \\\n> --mcap # --fast\nprinted\n```");
    assertProblem("--fast", "```yaml\n- run: ./eventchain run DIR --fast\n```");
    assertProblem("Missing required parameter", "    x && eventchain-*/bin/eventchain run");
  }

  private static void assertProblem(String expected, String text) {
    WrittenCommands written = new WrittenCommands(Parser.builder().build().parse(text));
    String problems = String.join("\n", problemsOf(written, ""));
    assertTrue(expected == null ? problems.isEmpty() : problems.contains(expected), problems);
  }

  private static String otherProgram(Path file) throws IOException {
    String program = OTHER_PROGRAMS.get(file.toString());
    return program == null ? "" : Files.readString(MarkdownFiles.ROOT.resolve(program));
  }

  private static List<String> problemsOf(WrittenCommands written, String otherProgram) {
    List<String> problems = new ArrayList<>();
    written.calls().forEach(call -> problemOf(call).ifPresent(problems::add));
    for (String span : written.spans()) {
      List<String> words = WrittenCommands.words(span);
      CommandLine command = words.isEmpty() ? null : subcommand(words.get(0));
      Set<String> options = command == null ? OPTIONS : optionsOf(command);
      if (span.startsWith("--") || command != null) {
        words.stream()
            .filter(word -> word.matches("--[a-z].*") && !options.contains(nameOf(word)))
            .filter(word -> !otherProgram.contains(nameOf(word)))
            .forEach(word -> problems.add(span + ": " + word));
      }
    }
    return problems;
  }

  private static Optional<String> problemOf(WrittenCommands.Call call) {
    CommandLine command = subcommand(call.words().isEmpty() ? "" : call.words().get(0));
    if (command != null) {
      for (String word : call.words()) {
        if (word.matches("-.+") && !optionsOf(command).contains(nameOf(word))) {
          return Optional.of(call.words() + ": " + word);
        }
      }
    }
    try {
      PROGRAM.parseArgs(call.words().toArray(String[]::new));
      return Optional.empty();
    } catch (MissingParameterException e) {
      return call.isComplete()
          ? Optional.of(call.words() + ": " + e.getMessage())
          : Optional.empty();
    } catch (ParameterException e) {
      boolean isPlaceholder = e.getValue() != null && e.getValue().matches("[A-Z]+");
      return isPlaceholder ? Optional.empty() : Optional.of(call.words() + ": " + e.getMessage());
    }
  }

  private static CommandLine subcommand(String name) {
    return PROGRAM.getSubcommands().get(name);
  }

  private static Set<String> optionsOf(CommandLine command) {
    Set<String> names = new HashSet<>(command.getCommandSpec().optionsMap().keySet());
    names.addAll(command.getCommandSpec().negatedOptionsMap().keySet());
    return names;
  }

  private static String nameOf(String option) {
    return option.replaceFirst("=.*", "");
  }
}
