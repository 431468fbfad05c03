package dev.eventchain.ocl;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Every diagnostic id of this bundle has a page and a case that shows it, and no page is stale. */
class RulePagesTest {

  private static final Pattern ID = Pattern.compile("\"(ocl\\.[a-z.-]+)\"");
  private static final Pattern SHOWN = Pattern.compile("\\[(ocl\\.[a-z.-]+)[ \\]]");

  @Test
  void everyIdHasAPageAndACase() throws IOException {
    Set<String> ids = find(Path.of("src", "main", "java"), ".java", ID);
    Set<String> pages = new TreeSet<>();
    try (Stream<Path> files = Files.list(Path.of("rules"))) {
      files.forEach(file -> pages.add(file.getFileName().toString().replaceFirst("\\.md$", "")));
    }
    assertEquals(ids, pages);
    assertEquals(ids, find(Path.of("src", "test", "resources"), "expected.txt", SHOWN));
  }

  private static Set<String> find(Path folder, String suffix, Pattern pattern) throws IOException {
    Set<String> found = new TreeSet<>();
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.filter(each -> each.toString().endsWith(suffix)).toList()) {
        Matcher matcher = pattern.matcher(Files.readString(file));
        while (matcher.find()) {
          found.add(matcher.group(1));
        }
      }
    }
    return found;
  }
}
