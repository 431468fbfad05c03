package dev.eventchain.project.requirements;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** The folders of a project and of its source, in which texts may name further files. */
final class TextFolders {

  /** Settings of Sphinx, in the folder from which names with a slash in front count. */
  private static final String SETTINGS = "conf.py";

  private final boolean isFolder;
  private final Path shown;
  private final Path folder;
  private final List<Path> roots;

  TextFolders(RequirementSource source) {
    Path file = source.file();
    Path beside = file.getParent() == null ? Path.of("") : file.getParent();
    this.isFolder = Files.isDirectory(file);
    this.shown = isFolder ? file : beside;
    this.folder = plain(shown);
    this.roots = List.of(folder, plain(source.project()));
  }

  private static Path plain(Path path) {
    return path.toAbsolutePath().normalize();
  }

  /**
   * Returns the file that a name stands for, which need not exist; empty if it is outside of the
   * folders, also by a link.
   */
  Optional<Path> find(Path from, String name) {
    try {
      Path base = name.startsWith("/") ? base(from) : plain(from).getParent();
      Path found = plain(base.resolve(name.replaceFirst("^/+", "")));
      return isInside(found)
          ? Optional.of(shown.resolve(folder.relativize(found)).normalize())
          : Optional.empty();
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  /**
   * Returns whether a pattern stands for files of a source that is a folder, which are all read.
   */
  boolean isRead(Path from, String pattern) {
    int wildcard = pattern.replaceAll("[*?\\[].*", "").length();
    String above = pattern.substring(0, pattern.lastIndexOf('/', wildcard) + 1);
    return isFolder
        && wildcard < pattern.length()
        && find(from, above).filter(it -> plain(it).startsWith(folder)).isPresent();
  }

  private Path base(Path from) {
    for (Path each = plain(from).getParent(); isBelow(each, roots); each = each.getParent()) {
      if (Files.isRegularFile(each.resolve(SETTINGS))) {
        return each;
      }
    }
    return folder;
  }

  private boolean isInside(Path found) {
    if (!isBelow(found, roots)) {
      return false;
    }
    try {
      return !Files.exists(found)
          || isBelow(
              found.toRealPath(), List.of(roots.get(0).toRealPath(), roots.get(1).toRealPath()));
    } catch (IOException e) {
      return false;
    }
  }

  private static boolean isBelow(Path path, List<Path> folders) {
    return path != null && folders.stream().anyMatch(path::startsWith);
  }
}
