package dev.eventchain.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

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

  private static final Pattern ID = Pattern.compile("\"((?:scenario|simulation)\\.[a-z.-]+)\"");

  @Test
  void everyFindingOfThisBundleHasAPageThatBeginsWithItsId() throws IOException {
    Set<String> ids = new TreeSet<>();
    try (Stream<Path> sources = Files.walk(Path.of("src/main/java"))) {
      for (Path source : sources.filter(Files::isRegularFile).toList()) {
        Matcher matcher = ID.matcher(Files.readString(source));
        while (matcher.find()) {
          ids.add(matcher.group(1));
        }
      }
    }
    assertTrue(ids.size() >= 10, ids::toString);
    for (String id : ids) {
      Path page = Path.of("rules", id + ".md");
      assertTrue(Files.exists(page), () -> "no page " + page);
      assertEquals("# " + id, Files.readAllLines(page).get(0));
    }
  }
}
