package dev.eventchain.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Each bundle says in a README what is in it, under its own name. */
class BundleReadmesTest {

  private static final Path BUNDLES = Path.of("..", "..", "bundles");

  @Test
  void everyBundleHasAReadme() throws IOException {
    List<String> without;
    try (Stream<Path> files = Files.list(BUNDLES)) {
      without =
          files
              .filter(folder -> Files.isRegularFile(folder.resolve("pom.xml")))
              .filter(folder -> !isDescribed(folder))
              .map(folder -> folder.getFileName().toString())
              .sorted()
              .toList();
    }
    assertEquals(List.of(), without);
  }

  @Test
  void theReadmeOfTheRootNamesEveryBundle() throws IOException {
    String readme = Files.readString(BUNDLES.resolveSibling("README.md"));
    try (Stream<Path> files = Files.list(BUNDLES)) {
      List<String> missing =
          files
              .filter(folder -> Files.exists(folder.resolve("README.md")))
              .map(folder -> "`bundles/" + folder.getFileName() + "/`")
              .filter(name -> !readme.contains(name))
              .sorted()
              .toList();
      assertEquals(List.of(), missing);
    }
  }

  @Test
  void aFolderWithoutAReadmeIsNoticed() {
    assertTrue(isDescribed(BUNDLES.resolve("m2t")));
    assertTrue(!isDescribed(BUNDLES.resolve("m2t").resolve("src")));
  }

  private static boolean isDescribed(Path folder) {
    try {
      Path readme = folder.resolve("README.md");
      return Files.exists(readme)
          && Files.readAllLines(readme).size() > 3
          && Files.readString(readme).matches("(?s)# " + folder.getFileName() + "\\b.*");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
