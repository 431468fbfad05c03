package dev.eventchain.lsp.project;

import dev.eventchain.lsp.check.WorkspaceFiles;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * A walk through what people write of a project: without its results, its recordings, projects
 * inside it, hidden folders and those of build tools. What cannot be read is left out.
 */
final class ProjectWalk extends SimpleFileVisitor<Path> {

  private static final int DEEPEST = 6;

  private final ProjectFolder project;
  private final List<Path> found = new ArrayList<>();

  private ProjectWalk(ProjectFolder project) {
    this.project = project;
  }

  /** Returns the files of a project, in the order of their paths. */
  static List<Path> files(ProjectFolder project) {
    ProjectWalk walk = new ProjectWalk(project);
    try {
      Files.walkFileTree(project.folder(), Set.of(), DEEPEST, walk);
    } catch (IOException e) {
      return List.of(); // the folder is gone meanwhile
    }
    return walk.found.stream().sorted().toList();
  }

  @Override
  public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
    boolean skipped =
        !folder.equals(project.folder())
            && (WorkspaceFiles.isPassedOver(folder)
                || folder.equals(project.defaultOutput())
                || folder.equals(project.folder().resolve(ProjectLayout.RECORDINGS))
                || Files.isRegularFile(new ProjectFolder(folder).configurationFile()));
    return skipped ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
  }

  @Override
  public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
    found.add(file);
    return FileVisitResult.CONTINUE;
  }

  @Override
  public FileVisitResult visitFileFailed(Path file, IOException e) {
    return FileVisitResult.CONTINUE;
  }

  @Override
  public FileVisitResult postVisitDirectory(Path folder, IOException e) {
    return FileVisitResult.CONTINUE;
  }
}
