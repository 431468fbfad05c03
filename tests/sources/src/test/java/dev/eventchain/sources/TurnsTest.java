package dev.eventchain.sources;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/**
 * Tests that the list of tests in turn names tests that exist. One that it lacks fails by itself.
 */
class TurnsTest {

  private static final Path TURNS =
      Path.of("../fixtures/src/main/resources/dev/eventchain/fixtures/turns.txt");

  @Test
  void allExist() throws IOException {
    Map<String, String> sources = sourcesOfTests();
    List<String> tests =
        Files.readAllLines(TURNS).stream()
            .filter(line -> !line.startsWith("#"))
            .map(line -> line.substring(line.indexOf(' ') + 1))
            .toList();
    assertTrue(tests.size() > 100, "only " + tests);
    assertEquals(List.of(), tests.stream().filter(test -> !isInTurn(test, sources)).toList());
  }

  /** Returns whether a method is marked, or asks for the day of a part of it. */
  private static boolean isInTurn(String test, Map<String, String> sources) {
    String type = test.substring(0, test.indexOf('.'));
    String source = sources.getOrDefault(type, "");
    int method = source.indexOf(" " + test.substring(type.length() + 1) + "(");
    int above = Math.max(0, source.lastIndexOf("\n\n", method));
    return (method > 0 && source.substring(above, method).contains("@InTurn"))
        || source.contains("isDayOf(\"" + test + "\")");
  }

  /** Returns the sources by the names of their classes; two classes may have the same. */
  private static Map<String, String> sourcesOfTests() throws IOException {
    Map<String, String> sources = new HashMap<>();
    for (Path file : SourceFiles.ofJava()) {
      String type = file.getFileName().toString().replace(".java", "");
      sources.merge(type, Files.readString(file), String::concat);
    }
    return sources;
  }
}
