package dev.eventchain.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tests that each bundle has a README with its name and contents, and that the map lists each. */
class BundleReadmesTest {

  @Test
  void everyBundleHasAReadme() throws IOException {
    assertEquals(
        List.of(), BundleFolders.all().stream().filter(folder -> !isDescribed(folder)).toList());
  }

  /** A row of the map names a group of bundles and the contents of each. */
  @Test
  void theReadmeOfTheRootNamesEveryBundle() throws IOException {
    String readme = Files.readString(BundleFolders.ROOT.resolve("README.md"));
    List<String> missing =
        BundleFolders.described().stream()
            .map(BundleFolders::path)
            .filter(path -> !isNamed(readme, path))
            .toList();
    assertEquals(List.of(), missing);
  }

  private static boolean isNamed(String readme, String path) {
    int slash = path.lastIndexOf('/');
    String group = "| `" + path.substring(0, slash + 1) + "` |";
    String name = "`" + path.substring(slash + 1) + "`";
    try (Stream<String> lines = readme.lines()) {
      return readme.contains("`" + path + "/`")
          || lines.anyMatch(line -> line.startsWith(group) && line.contains(name));
    }
  }

  @Test
  void aFolderWithoutAReadmeIsNoticed() {
    Path engine = BundleFolders.BUNDLES.resolve("mde/m2t");
    assertTrue(isDescribed(engine));
    assertFalse(isDescribed(engine.resolve("src")));
    assertFalse(isNamed("| `bundles/mde/` | `ocl` |", "bundles/mde/m2t"));
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
