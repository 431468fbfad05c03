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
import org.junit.jupiter.api.Test;

/** Tests that the version in copyable Markdown and in the changelog is that of the build. */
class VersionTest {

  private static final Pattern OF_THE_BUILD =
      Pattern.compile("<artifactId>eventchain</artifactId>\\s*<version>([^<]+)</version>");
  private static final Pattern OF_AN_EXAMPLE =
      Pattern.compile("<artifactId>eventchain-[a-z-]+</artifactId>\\s*<version>([^<]+)</version>");
  private static final Pattern OF_THE_CHANGELOG = Pattern.compile("(?m)^## (\\S+)");

  @Test
  void examplesNameTheVersionOfTheBuild() throws IOException {
    List<String> named = new ArrayList<>();
    for (Path file : MarkdownFiles.in(MarkdownFiles.ROOT).keySet()) {
      named.addAll(versions(OF_AN_EXAMPLE, file));
    }
    assertTrue(!named.isEmpty(), "no example names a version");
    named.removeIf(version()::equals);
    assertEquals(List.of(), named);
  }

  @Test
  void theChangelogBeginsWithTheVersionOfTheBuildOrWithWhatIsUnreleased() throws IOException {
    String newest = versions(OF_THE_CHANGELOG, Path.of("CHANGELOG.md")).get(0);
    assertEquals(version().endsWith("-SNAPSHOT") ? "Unreleased" : version(), newest);
  }

  private static String version() throws IOException {
    return versions(OF_THE_BUILD, Path.of("pom.xml")).get(0);
  }

  private static List<String> versions(Pattern pattern, Path file) throws IOException {
    return pattern
        .matcher(Files.readString(MarkdownFiles.ROOT.resolve(file)))
        .results()
        .map((MatchResult match) -> match.group(1))
        .toList();
  }
}
