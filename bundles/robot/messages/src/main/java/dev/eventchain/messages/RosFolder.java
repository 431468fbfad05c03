package dev.eventchain.messages;

import java.io.IOException;
import java.nio.file.FileSystemLoopException;
import java.nio.file.FileVisitOption;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * The files of a folder with ROS 2 packages, such as a colcon workspace, and the packages that hold
 * them.
 *
 * <p>Below the folder, what colcon passes over is left out: hidden folders, those with {@code
 * COLCON_IGNORE} or {@code AMENT_IGNORE}, and {@code build}, {@code install} and {@code log}. Links
 * are followed, but not into folders that they are in.
 *
 * @param packages by their folders; a package holds no other package
 * @param files all files, also those outside packages
 */
public record RosFolder(SortedMap<Path, RosPackage> packages, SortedSet<Path> files) {

  private static final Set<String> IGNORED = Set.of("COLCON_IGNORE", "AMENT_IGNORE");
  private static final Set<String> RESULTS = Set.of("build", "install", "log");

  /**
   * Lists a folder.
   *
   * @throws IOException if it, or a folder in it, cannot be read
   */
  public static RosFolder list(Path root) throws IOException {
    Lister lister = new Lister(root);
    Files.walkFileTree(root, EnumSet.of(FileVisitOption.FOLLOW_LINKS), Integer.MAX_VALUE, lister);
    return new RosFolder(lister.packages, lister.files);
  }

  /** Returns the package that a file or folder is in. */
  public Optional<RosPackage> packageOf(Path file) {
    for (Path above = file; above != null; above = above.getParent()) {
      RosPackage found = packages.get(above);
      if (found != null) {
        return Optional.of(found);
      }
    }
    return Optional.empty();
  }

  /** Returns the name of a file from its package on, or else from a folder on. */
  String nameOf(Path file, Path otherwise) {
    Optional<RosPackage> owner = packageOf(file);
    Path above = owner.map(RosPackage::folder).orElse(otherwise);
    String name = above.relativize(file).toString().replace('\\', '/');
    return owner.map(it -> it.name() + "/" + name).orElse(name);
  }

  private static final class Lister extends SimpleFileVisitor<Path> {

    private final Path root;
    private final SortedMap<Path, RosPackage> packages = new TreeMap<>();
    private final SortedSet<Path> files = new TreeSet<>();
    private Path within;

    Lister(Path root) {
      this.root = root;
    }

    @Override
    public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
      if (!folder.equals(root) && isPassedOver(folder)) {
        return FileVisitResult.SKIP_SUBTREE;
      }
      if (within == null) {
        RosPackage.of(folder)
            .ifPresent(
                found -> {
                  packages.put(folder, found);
                  within = folder;
                });
      }
      return FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult postVisitDirectory(Path folder, IOException problem) throws IOException {
      if (folder.equals(within)) {
        within = null;
      }
      return super.postVisitDirectory(folder, problem);
    }

    @Override
    public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
      files.add(file);
      return FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult visitFileFailed(Path file, IOException problem) throws IOException {
      if (problem instanceof FileSystemLoopException) {
        return FileVisitResult.CONTINUE;
      }
      return super.visitFileFailed(file, problem);
    }

    /** A folder of results may also be a package of that name. */
    private static boolean isPassedOver(Path folder) {
      String name = folder.getFileName().toString();
      boolean isResult =
          RESULTS.contains(name)
              && !Files.exists(folder.resolve(RosPackage.MANIFEST))
              && !Files.exists(folder.resolve("msg"))
              && !Files.exists(folder.resolve("srv"));
      return name.startsWith(".")
          || isResult
          || IGNORED.stream().anyMatch(marker -> Files.exists(folder.resolve(marker)));
    }
  }
}
