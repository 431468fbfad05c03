package dev.eventchain.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tests the built site: its pages, and the Javadoc that they link to. */
class SiteTest {

  private static final Path SITE =
      Path.of("..", "..", "bundles", "documentation", "target", "site");
  private static final Pattern LINK = Pattern.compile("(?:href|src)=\"([^\"#]+)");

  @Test
  void linksOfThePagesLeadToFiles() throws IOException {
    List<String> broken = new ArrayList<>();
    int toJavadoc = 0;
    for (Path page : pages()) {
      for (String link : links(page)) {
        toJavadoc += link.startsWith("apidocs/dev/") ? 1 : 0;
        if (!Files.isRegularFile(page.resolveSibling(link))) {
          broken.add(SITE.relativize(page) + ": " + link);
        }
      }
    }
    assertEquals(List.of(), broken);
    assertTrue(toJavadoc >= 8, toJavadoc + " links to the Javadoc of a class");
  }

  @Test
  void javadocHasThePublicPackagesAndTheirContracts() throws IOException {
    List<String> packages = Files.readAllLines(SITE.resolve("apidocs/element-list"));
    assertTrue(packages.contains("dev.eventchain.constraints"), packages::toString);
    assertTrue(packages.contains("dev.eventchain.model.eventchain"), "generated code, too");
    assertTrue(packages.stream().noneMatch(name -> name.endsWith(".impl")), packages::toString);
    String page =
        Files.readString(SITE.resolve("apidocs/dev/eventchain/constraints/OclValidator.html"));
    assertTrue(page.contains("Parameters:"), page);
  }

  private static List<Path> pages() throws IOException {
    try (Stream<Path> files = Files.walk(SITE)) {
      return files
          .filter(file -> file.toString().endsWith(".html"))
          .filter(file -> !file.startsWith(SITE.resolve("apidocs")))
          .sorted()
          .toList();
    }
  }

  private static List<String> links(Path page) throws IOException {
    return LINK.matcher(Files.readString(page))
        .results()
        .map((MatchResult m) -> m.group(1))
        .toList();
  }
}
