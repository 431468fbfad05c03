package dev.eventchain.sources;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;

/** Hand-written source files of the repository, sorted by path. */
final class SourceFiles {

  private static final Path ROOT = Path.of("..", "..");
  private static final Path BUNDLES = ROOT.resolve("bundles");

  private SourceFiles() {}

  /** Returns the code that ships, in files that end with this. */
  static List<Path> ofBundles(String suffix) throws IOException {
    return files(
        BUNDLES,
        file -> file.endsWith(suffix) && file.matches("([^/]+/){1,3}(src/main|python)/.*"));
  }

  /** Returns the Java files of bundles and tests. */
  static List<Path> ofJava() throws IOException {
    Predicate<String> java = file -> file.matches(".*/src/(main|test)/java/.*\\.java");
    List<Path> all = new ArrayList<>(files(BUNDLES, java));
    all.addAll(files(ROOT.resolve("tests"), java));
    return all;
  }

  /** Returns the files below a folder whose relative path, with slashes, is wanted. */
  private static List<Path> files(Path root, Predicate<String> wanted) throws IOException {
    List<Path> found = new ArrayList<>();
    Files.walkFileTree(
        root,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
            boolean generated = folder.endsWith("target") || folder.endsWith("node_modules");
            return generated ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
            if (wanted.test(root.relativize(file).toString().replace('\\', '/'))) {
              found.add(file);
            }
            return FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFileFailed(Path file, IOException failure)
              throws IOException {
            if (failure instanceof NoSuchFileException) {
              return FileVisitResult.CONTINUE; // Other bundles are tested meanwhile.
            }
            throw failure;
          }
        });
    assertTrue(found.size() > 20, () -> "only " + found);
    return found.stream().sorted().toList();
  }
}
