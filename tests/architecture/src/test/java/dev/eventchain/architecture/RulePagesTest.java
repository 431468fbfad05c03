package dev.eventchain.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.RulePage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * Tests that every reported finding has exactly one page and a test, and that every page explains a
 * reported finding.
 */
class RulePagesTest {

  private static final Path BUNDLES = Path.of("..", "..", "bundles");
  private static final Pattern ID =
      Pattern.compile("[\"']([a-z0-9]+(?:\\.[a-z0-9]+(?:-[a-z0-9]+)*)+)[\"']");

  /** Property of a Maven plug-in parameter on the command line. */
  private static final Pattern PROPERTY = Pattern.compile("property = \"[^\"]*\"");

  /** Suffixes of names that look like identifiers but are files, fields or properties. */
  private static final Set<String> NO_IDS =
      Set.of(
          "bash",
          "json",
          "py",
          "xmi",
          "ocl",
          "ecore",
          "js",
          "css",
          "html",
          "txt",
          "yaml",
          "md",
          "msgs",
          "lobster",
          "explain",
          "simulate");

  /**
   * Rules without a test: a disk failure during writing, an interrupt inside the JVM, and a node
   * process that breaks its protocol.
   */
  private static final Set<String> WITHOUT_A_TEST =
      Set.of(
          "llm.recording.unwritable",
          "message.malformed",
          "protocol.frame",
          "simulation.interrupted");

  /** Bundles with a page, by identifier. */
  private static final Map<String, List<String>> PAGES = new TreeMap<>();

  private static List<String> sources;

  /** The words of a source in quotes, and those that end a Python format string after a dot. */
  private record Words(Set<String> quoted, Set<String> formatted) {

    private static final Pattern QUOTED = Pattern.compile("([\"'])([a-z0-9.-]+)(?=\\1)");
    private static final Pattern FORMATTED = Pattern.compile("}\\.([a-z0-9.-]*)(?=\")");

    static Words of(String source) {
      return new Words(all(QUOTED, 2, source), all(FORMATTED, 1, source));
    }

    private static Set<String> all(Pattern pattern, int group, String source) {
      return pattern
          .matcher(source)
          .results()
          .map(match -> match.group(group))
          .collect(Collectors.toSet());
    }
  }

  @BeforeAll
  static void read() throws IOException {
    try (Stream<Path> files = Files.walk(BUNDLES, 5)) {
      for (Path file : files.filter(RulePagesTest::isPage).sorted().toList()) {
        String id = file.getFileName().toString().replaceFirst("\\.md$", "");
        String bundle = file.getParent().getParent().getFileName().toString();
        PAGES.computeIfAbsent(id, key -> new ArrayList<>()).add(bundle);
        assertEquals("# " + id, Files.readAllLines(file).get(0), file.toString());
      }
    }
    String folders = "/(?:(?!src/)[a-z0-9-]+/){1,3}(?:src/main|python)/";
    sources = texts(BUNDLES, Pattern.compile(".*/bundles" + folders + ".*\\.(java|py)"));
  }

  private static boolean isPage(Path file) {
    return file.getParent().endsWith("rules") && file.toString().endsWith(".md");
  }

  @Test
  void everyIdHasExactlyOnePage() {
    Set<String> kinds =
        PAGES.keySet().stream()
            .map(id -> id.replaceFirst("\\..*", ""))
            .collect(Collectors.toCollection(TreeSet::new));
    Set<String> missing = new TreeSet<>();
    for (String source : sources) {
      Matcher id = ID.matcher(PROPERTY.matcher(source).replaceAll(""));
      while (id.find()) {
        String name = id.group(1);
        boolean isId =
            kinds.contains(name.replaceFirst("\\..*", ""))
                && !NO_IDS.contains(name.replaceFirst(".*\\.", ""));
        if (isId && !PAGES.containsKey(name)) {
          missing.add(name);
        }
      }
    }
    assertEquals(Set.of(), missing, "ids without a page");
    PAGES.forEach((id, bundles) -> assertEquals(1, bundles.size(), id + " in " + bundles));
  }

  @Test
  void everyPageExplainsAFindingThatIsReported() {
    List<Words> words = sources.stream().map(Words::of).toList();
    List<String> unused = PAGES.keySet().stream().filter(id -> !isReported(id, words)).toList();
    assertEquals(List.of(), unused, "pages about nothing");
  }

  /**
   * Returns whether an identifier occurs in quotes, or is composed in one file: from a prefix that
   * ends with a dot, or in a Python format string.
   */
  private static boolean isReported(String id, List<Words> files) {
    for (int dot = id.length(); dot > 0; dot = id.lastIndexOf('.', dot - 1)) {
      String first = dot == id.length() ? id : id.substring(0, dot + 1);
      String second = dot == id.length() ? "" : id.substring(dot + 1);
      for (Words words : files) {
        boolean formatted =
            words.formatted().contains(second)
                && words.quoted().contains(first.substring(0, first.length() - 1));
        if (formatted
            || (words.quoted().contains(first)
                && (second.isEmpty() || words.quoted().contains(second)))) {
          return true;
        }
      }
    }
    return false;
  }

  @Test
  void everyFindingIsShownByATest() throws IOException {
    Pattern tests = Pattern.compile(".*/src/(?:test|it)/.*|.*/robot/runtime/tests/.*\\.py");
    StringBuilder all = new StringBuilder();
    for (Path folder :
        List.of(BUNDLES, Path.of("..", "closed-loop"), Path.of("..", "end-to-end"))) {
      texts(folder, tests).forEach(text -> all.append(text).append('\n'));
    }
    Set<String> mentioned = new TreeSet<>();
    Matcher id = Pattern.compile("[a-z0-9]+(?:[.-][a-z0-9]+)+").matcher(all);
    while (id.find()) {
      mentioned.add(id.group());
    }
    Set<String> untested = new TreeSet<>(PAGES.keySet());
    untested.removeAll(mentioned);
    assertEquals(WITHOUT_A_TEST, untested);
  }

  @Test
  void theJarsHoldThePages() {
    Set<String> packaged =
        RulePage.all().stream().map(RulePage::id).collect(Collectors.toCollection(TreeSet::new));
    Set<String> ofJars = new TreeSet<>(PAGES.keySet());
    ofJars.removeIf(id -> id.startsWith("eclipse.")); // in the plug-in, which shows them itself
    assertEquals(ofJars, packaged);
    for (RulePage page : RulePage.all()) {
      assertEquals(PAGES.get(page.id()), List.of(page.bundle()), page.id());
      assertFalse(page.firstSentence().isBlank(), page.id());
      assertTrue(page.firstSentence().length() < 400, page.firstSentence());
    }
  }

  private static List<String> texts(Path folder, Pattern name) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      return files
          .filter(file -> name.matcher(file.toString().replace('\\', '/')).matches())
          .filter(Files::isRegularFile)
          .sorted()
          .map(RulePagesTest::text)
          .toList();
    }
  }

  /** Returns the text of a file; fixtures may not be UTF-8. */
  private static String text(Path file) {
    try {
      return new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
