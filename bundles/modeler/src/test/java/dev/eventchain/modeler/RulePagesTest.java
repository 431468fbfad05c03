package dev.eventchain.modeler;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Each rule has a page, and a test in which it speaks. */
class RulePagesTest {

  private static final Pattern RULE = Pattern.compile("[\\[\"]((?:modeler)\\.[a-z.-]+)[\\]\"]");

  @Test
  void pagesAndTestedRulesAreTheSame() throws IOException {
    Set<String> pages;
    try (Stream<Path> files = Files.list(Path.of("rules"))) {
      pages =
          files
              .map(file -> file.getFileName().toString().replaceFirst("\\.md$", ""))
              .collect(Collectors.toCollection(TreeSet::new));
    }
    assertEquals(pages, testedRules());
  }

  private static Set<String> testedRules() throws IOException {
    Set<String> rules = new TreeSet<>();
    try (Stream<Path> files = Files.walk(Path.of("src/test"))) {
      files
          .filter(file -> file.toString().matches(".*(Test\\.java|expected\\.txt)"))
          .forEach(file -> collect(file, rules));
    }
    return rules;
  }

  private static void collect(Path file, Set<String> rules) {
    try {
      Matcher rule = RULE.matcher(Files.readString(file));
      while (rule.find()) {
        rules.add(rule.group(1));
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
