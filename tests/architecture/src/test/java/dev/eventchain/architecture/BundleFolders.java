package dev.eventchain.architecture;

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

  /** Returns all folders, sorted by path. The Eclipse plug-ins count as one. */
  static List<Path> all() throws IOException {
    try (Stream<Path> folders = Files.walk(BUNDLES, DEEPEST)) {
      return folders
          .filter(folder -> !folder.equals(BUNDLES))
          .filter(folder -> Files.isRegularFile(folder.resolve("pom.xml")))
          .sorted()
          .toList();
    }
  }

  /** Returns the path from the root, such as {@code bundles/mde/ocl}. */
  static String path(Path folder) {
    return ROOT.relativize(folder).toString().replace('\\', '/');
  }
}
