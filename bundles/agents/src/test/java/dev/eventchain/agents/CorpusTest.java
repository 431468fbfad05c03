package dev.eventchain.agents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * The invalid answers next to this test: their number and kinds. The tests of the single tasks
 * compare each of them with the findings in the file next to it.
 */
class CorpusTest {
  private static final Path RESOURCES = Path.of("src/test/resources");
  private static final List<String> FOLDERS =
      List.of(
          "design",
          "model",
          "constrain",
          "implement",
          "answers/json",
          "answers/python",
          "answers/ocl");

  /** Known kinds of faults in answers of language models. */
  private static final Set<String> KNOWN =
      Set.of(
          "fences",
          "preamble",
          "trailing prose or commas",
          "truncation",
          "nested object as string",
          "wrong or case-variant keys",
          "dangling ids",
          "duplicate ids",
          "cycles",
          "wrong class",
          "string for number and other types",
          "Hz for ms, ms for Hz",
          "km/h for m/s, m/s for km/h",
          "invented topic",
          "field not in the message",
          "missing package prefix, invented packages",
          "names that are no Python identifiers",
          "names with template brackets, quotes, ../",
          "missing or renamed execute",
          "wrong argument names",
          "non-dict or missing key",
          "NaN and infinity",
          "division by zero closing speed",
          "sign error",
          "state outside the class",
          "rclpy import",
          "os, subprocess, eval, file, network",
          "endless loop",
          "side effects at import",
          "an edge case is missed",
          "unknown feature",
          "collection versus scalar nextstep",
          "tautology",
          "never evaluated");

  @Test
  void everyRefusedAnswerIsInTheTableAndEveryAnswerOfTheTableIsRefused() throws IOException {
    List<String> listed = new ArrayList<>();
    classes().values().forEach(listed::addAll);
    assertEquals(new TreeSet<>(refused()), new TreeSet<>(listed));
    assertEquals(new TreeSet<>(listed).size(), listed.size(), "one stands there twice");
  }

  @Test
  void thereAreAtLeast150() throws IOException {
    List<String> refused = refused();
    assertTrue(refused.size() >= 150, () -> "only " + refused.size());
    Map<String, Long> byFolder =
        refused.stream().collect(Collectors.groupingBy(CorpusTest::folder, Collectors.counting()));
    assertEquals(new TreeSet<>(FOLDERS), new TreeSet<>(byFolder.keySet()));
  }

  @Test
  void everyKnownClassHasThreeMembersOrAReasonWhyItCannotBeSeen() throws IOException {
    Map<String, List<String>> classes = classes();
    classes.keySet().removeIf(name -> name.startsWith("other: "));
    Map<String, Integer> few = new TreeMap<>();
    classes.forEach((name, members) -> few.put(name, members.size()));
    few.values().removeIf(count -> count >= 3);
    assertEquals(Map.of(), few);
    Set<String> invisible = invisible();
    invisible.forEach(name -> assertTrue(!classes.containsKey(name), name));
    Set<String> all = new TreeSet<>(classes.keySet());
    all.addAll(invisible);
    assertEquals(new TreeSet<>(KNOWN), all);
  }

  /** Returns the answers whose expected findings contain an error. */
  private static List<String> refused() throws IOException {
    List<String> refused = new ArrayList<>();
    for (String folder : FOLDERS) {
      try (Stream<Path> files = Files.list(RESOURCES.resolve(folder))) {
        for (Path file : files.filter(Files::isRegularFile).sorted().toList()) {
          String name = file.getFileName().toString();
          Path expected = file.resolveSibling(name.replaceFirst("\\.[a-z]+$", ".expected"));
          boolean isAnswer = !expected.equals(file) && Files.exists(expected);
          if (isAnswer && Files.readAllLines(expected).stream().anyMatch(CorpusTest::isError)) {
            refused.add(folder + "/" + name);
          }
        }
      }
    }
    return refused;
  }

  private static boolean isError(String line) {
    return line.matches("error \\d+:\\d+ .*");
  }

  private static String folder(String file) {
    return file.substring(0, file.lastIndexOf('/'));
  }

  private static Map<String, List<String>> classes() throws IOException {
    Map<String, List<String>> classes = new LinkedHashMap<>();
    List<String> members = new ArrayList<>();
    for (String line : table()) {
      if (line.startsWith("= ")) {
        members = new ArrayList<>();
        classes.put(line.substring(2), members);
      } else if (!line.startsWith("! ")) {
        members.add(line);
      }
    }
    return classes;
  }

  private static Set<String> invisible() throws IOException {
    return table().stream()
        .filter(line -> line.startsWith("! "))
        .map(line -> line.substring(2, line.indexOf(": ")))
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private static List<String> table() throws IOException {
    return Files.readAllLines(RESOURCES.resolve("corpus.txt")).stream()
        .filter(line -> !line.isBlank() && !line.startsWith("#"))
        .toList();
  }
}
