package dev.eventchain.architecture;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** Folders of the bundles: those below {@code bundles/} that are modules of the build. */
final class BundleFolders {

  static final Path ROOT = Path.of("..", "..");
  static final Path BUNDLES = ROOT.resolve("bundles");

  private static final int DEEPEST = 2; // bundles/GROUP/BUNDLE

  private BundleFolders() {}

  /** Returns the folders of the modules, sorted by path; the plug-ins for Eclipse are one. */
  static List<Path> all() throws IOException {
    return with("pom.xml");
  }

  /** Returns the folders with a README, sorted by path: also those that are no modules. */
  static List<Path> described() throws IOException {
    return with("README.md");
  }

  private static List<Path> with(String file) throws IOException {
    try (Stream<Path> folders = Files.walk(BUNDLES, DEEPEST)) {
      List<Path> found =
          folders
              .filter(folder -> !folder.equals(BUNDLES))
              .filter(folder -> Files.isRegularFile(folder.resolve(file)))
              .sorted()
              .toList();
      assertTrue(found.size() > 20, () -> "only " + found);
      return found;
    }
  }

  /** Returns the path from the root, such as {@code bundles/mde/ocl}. */
  static String path(Path folder) {
    return ROOT.relativize(folder).toString().replace('\\', '/');
  }
}
