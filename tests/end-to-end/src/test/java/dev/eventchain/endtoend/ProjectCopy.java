package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * A copy of an example, for a test to change and to run.
 *
 * @param path the folder
 */
record ProjectCopy(Path path) {

  /** Copies an example into a folder. */
  static ProjectCopy of(String example, Path folder) throws IOException {
    return new ProjectCopy(Program.copyOf(example, folder));
  }

  /** Replaces a text that occurs once in a file. */
  void replace(String file, String text, String by) throws IOException {
    String content = Files.readString(path.resolve(file));
    assertEquals(1, content.split(Pattern.quote(text), -1).length - 1, text);
    write(file, content.replace(text, by));
  }

  /** Writes a file of the project. */
  void write(String file, String content) throws IOException {
    Files.createDirectories(path.resolve(file).getParent());
    Files.writeString(path.resolve(file), content);
  }

  /** Deletes a folder of the project. */
  void delete(String name) throws IOException {
    try (Stream<Path> files = Files.walk(path.resolve(name))) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(file);
      }
    }
  }

  /** Keeps one scenario only, if one criterion is enough. */
  void onlyScenario(String scenario) throws IOException {
    try (Stream<Path> files = Files.list(path.resolve("scenarios"))) {
      for (Path file : files.filter(each -> !path.resolve(scenario).equals(each)).toList()) {
        Files.delete(file);
      }
    }
  }

  /** Ends the scenario of the radar example earlier: by then, the vehicle stands. */
  void endAtEightSeconds() throws IOException {
    String scenario = "scenarios/stopped-vehicle-50.yaml";
    String text = Files.readString(path.resolve(scenario));
    assertTrue(text.contains("duration_s: 12\n") && text.contains(", 11.5]"), text);
    write(
        scenario, text.replace("duration_s: 12\n", "duration_s: 8\n").replace(", 11.5]", ", 7.5]"));
  }

  /** Runs all stages. */
  Program.Ended run() {
    return new Program().run("run", path);
  }

  /** Fails if there is a verdict PASSED. */
  void requireNotPassed() throws IOException {
    Path verdict = path.resolve("out/verdict.json");
    assertFalse(
        Files.exists(verdict)
            && Files.readString(verdict).contains("\"passed\" : true,\n  \"scenarios"));
  }
}
