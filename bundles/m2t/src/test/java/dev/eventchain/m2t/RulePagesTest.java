package dev.eventchain.m2t;

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

class RulePagesTest {
  private static final Pattern ID =
      Pattern.compile("\"((?:m2t|output|eventchain)\\.[a-z]+(?:[.-][a-z]+)*)\"");

  @Test
  void everyIdHasItsPageAndEveryPageItsId() throws IOException {
    Set<String> ids = new TreeSet<>();
    try (Stream<Path> sources = Files.walk(Path.of("src/main/java"))) {
      for (Path source : sources.filter(Files::isRegularFile).toList()) {
        Matcher matcher = ID.matcher(Files.readString(source));
        while (matcher.find()) {
          ids.add(matcher.group(1));
        }
      }
    }
    Set<String> pages = new TreeSet<>();
    try (Stream<Path> files = Files.list(Path.of("rules"))) {
      files.forEach(file -> pages.add(file.getFileName().toString().replace(".md", "")));
    }
    assertEquals(pages, ids);
  }
}
