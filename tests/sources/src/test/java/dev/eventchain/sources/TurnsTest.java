package dev.eventchain.sources;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/**
 * Tests that the list of tests in turn names tests that exist. One that it lacks fails by itself.
 */
class TurnsTest {

  private static final Path TURNS =
      Path.of("../fixtures/src/main/resources/dev/eventchain/fixtures/turns.txt");

  /** A class, perhaps behind the last part of its package, and what it calls the test. */
  private static final Pattern NAME = Pattern.compile("((?:[a-z]\\w*\\.)?[A-Z]\\w*)\\.(.+)");

  @Test
  void allExist() throws IOException {
    Map<String, List<String>> sources = sourcesOfTests();
    List<String> tests =
        Files.readAllLines(TURNS).stream()
            .filter(line -> !line.startsWith("#"))
            .map(line -> line.substring(line.indexOf(' ') + 1))
            .toList();
    assertTrue(tests.size() > 100, "only " + tests);
    assertEquals(List.of(), tests.stream().filter(test -> !isInTurn(test, sources)).toList());
  }

  @Test
  void classesOfOneNameAreToldApart() throws IOException {
    Map<String, List<String>> sources = sourcesOfTests();
    String test = "DdsDriverTest.noNetworkIsNeededButLoopback";
    assertEquals(2, sources.get("DdsDriverTest").size());
    assertFalse(isInTurn(test, sources));
    assertFalse(isInTurn("simulation." + test, sources));
    assertTrue(isInTurn("endtoend." + test, sources));
  }

  /** Returns whether a method of one class is marked, or asks for the day of a part of it. */
  private static boolean isInTurn(String test, Map<String, List<String>> sources) {
    Matcher name = NAME.matcher(test);
    assertTrue(name.matches(), test);
    List<String> named = sources.getOrDefault(name.group(1), List.of());
    if (named.size() != 1) {
      return false;
    }
    String source = named.get(0);
    int method = source.indexOf(" " + name.group(2) + "(");
    int above = Math.max(0, source.lastIndexOf("\n\n", method));
    return (method > 0 && source.substring(above, method).contains("@InTurn"))
        || source.contains("isDayOf(\"" + test + "\")");
  }

  /** Returns the sources by the names of their classes, without and with their folders. */
  private static Map<String, List<String>> sourcesOfTests() throws IOException {
    Map<String, List<String>> sources = new HashMap<>();
    for (Path file : SourceFiles.ofJava()) {
      String type = file.getFileName().toString().replace(".java", "");
      String folder = file.getParent().getFileName().toString();
      for (String name : List.of(type, folder + "." + type)) {
        sources.computeIfAbsent(name, key -> new ArrayList<>()).add(Files.readString(file));
      }
    }
    return sources;
  }
}
