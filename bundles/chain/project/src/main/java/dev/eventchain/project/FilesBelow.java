package dev.eventchain.project;

import java.io.IOException;
import java.nio.file.FileSystemLoopException;
import java.nio.file.FileVisitOption;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.EnumSet;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;

/** Collects the files in and below a folder. A link into a folder that it is in is passed over. */
final class FilesBelow extends SimpleFileVisitor<Path> {

  private final SortedSet<Path> files = new TreeSet<>();

  private FilesBelow() {}

  /** Returns the files, without compiled Python files. */
  static List<Path> list(Path folder) throws IOException {
    FilesBelow found = new FilesBelow();
    Files.walkFileTree(folder, EnumSet.of(FileVisitOption.FOLLOW_LINKS), Integer.MAX_VALUE, found);
    return found.files.stream().filter(file -> !file.toString().contains("__pycache__")).toList();
  }

  @Override
  public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
    boolean isLinkToNothing = Files.isSymbolicLink(file) && !Files.exists(file);
    if (attributes.isRegularFile() || isLinkToNothing) {
      files.add(file);
    }
    return FileVisitResult.CONTINUE;
  }

  @Override
  public FileVisitResult visitFileFailed(Path file, IOException problem) throws IOException {
    return problem instanceof FileSystemLoopException
        ? FileVisitResult.CONTINUE
        : super.visitFileFailed(file, problem);
  }
}
