package dev.eventchain.pipeline.format;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * The files that a command formats: named ones, and those in named folders that people write. In
 * folders, links are not followed, and YAML counts in projects only.
 */
final class FormattedFiles {

  private static final Set<String> BUILT = Set.of("node_modules", "target", "__pycache__");

  private final List<Diagnostic> found;

  /** Files as they are named, by where they are. */
  private final Map<Path, Path> files = new LinkedHashMap<>();

  private FormattedFiles(List<Diagnostic> found) {
    this.found = found;
  }

  /**
   * Returns the files, each once, as they are named.
   *
   * @param found receives what is wrong with the names
   * @throws DiagnosticException INPUT if there is no file or folder of a name
   */
  static List<Path> of(List<Path> named, List<Diagnostic> found) {
    FormattedFiles all = new FormattedFiles(found);
    named.forEach(all::add);
    return List.copyOf(all.files.values());
  }

  private void add(Path named) {
    try {
      Path real = named.toRealPath();
      boolean isFolder = Files.isDirectory(real);
      if (!isInside(named, real)) {
        found.add(
            Diagnostic.of(
                    FormatRules.OUTSIDE,
                    "This is a link that leads out of its project, and is not followed.",
                    SourceLocation.of(named))
                .withHint("Name what it leads to: " + real));
      } else if (isFolder) {
        addFolder(named, real);
      } else {
        addFile(named, real);
      }
    } catch (NoSuchFileException e) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
              FileRules.MISSING, "There is no such file or folder.", SourceLocation.of(named)));
    } catch (IOException e) {
      throw FileRules.refusal("The file or folder", named, e);
    }
  }

  private void addFile(Path named, Path real) {
    if (TextFormat.of(named).isEmpty()) {
      found.add(nothing(named, "This is no file of constraints, no template and no YAML."));
    } else if (isInRuns(real) || writtenAround(real).contains(real)) {
      found.add(
          Diagnostic.of(
                  FormatRules.SKIPPED,
                  "The file is left as it is, since it is a result or a recording.",
                  SourceLocation.of(named))
              .withHint("Leave it out: the next run writes it again as it was."));
    } else {
      files.putIfAbsent(real, named);
    }
  }

  private static Diagnostic nothing(Path named, String message) {
    return Diagnostic.of(FormatRules.NOTHING, message, SourceLocation.of(named))
        .withHint("Name files that end with .ocl, .mtl, .yaml or .yml, or folders of such files.");
  }

  /** Returns whether a file or folder is where its name says, or elsewhere in the same project. */
  private static boolean isInside(Path named, Path real) throws IOException {
    Optional<ProjectFolder> project = project(named);
    return project.isEmpty() || real.startsWith(project.get().folder().toRealPath());
  }

  /** Returns the project that a file belongs to, or that a folder is or belongs to. */
  static Optional<ProjectFolder> project(Path named) {
    ProjectFolder itself = new ProjectFolder(named);
    return Files.isRegularFile(itself.configurationFile())
        ? Optional.of(itself)
        : ProjectFolder.around(named);
  }

  private void addFolder(Path named, Path real) throws IOException {
    List<Path> inside = new ArrayList<>();
    if (!isInRuns(real)) {
      Files.walkFileTree(real, new Walk(real, inside));
    }
    if (inside.isEmpty()) {
      found.add(nothing(named, "There is nothing to format in this folder."));
    }
    inside.stream()
        .sorted()
        .forEach(each -> files.putIfAbsent(each, named.resolve(real.relativize(each))));
  }

  private static Stream<Path> andAbove(Path path) {
    return Stream.iterate(path, Objects::nonNull, Path::getParent);
  }

  private static boolean isInRuns(Path real) {
    return andAbove(real).anyMatch(FormattedFiles::isOfRuns);
  }

  /** Returns the files that the records of the folders above a file or folder name. */
  private static Set<Path> writtenAround(Path real) {
    Set<Path> written = new HashSet<>();
    andAbove(real.getParent()).forEach(folder -> addWritten(folder, written));
    return written;
  }

  private static void addWritten(Path folder, Set<Path> written) {
    try {
      OutputFolder.writtenBelow(folder).forEach(name -> written.add(folder.resolve(name)));
    } catch (IOException | InvalidPathException e) {
      // With unreadable records, no file counts as written by the program.
    }
  }

  /** Returns whether a folder is that of the results or the recordings of a project. */
  private static boolean isOfRuns(Path folder) {
    return (folder.endsWith(ProjectLayout.OUTPUT) || folder.endsWith(ProjectLayout.RECORDINGS))
        && Files.isRegularFile(new ProjectFolder(folder.getParent()).configurationFile());
  }

  /** Walk through what people write below a folder. */
  private final class Walk extends SimpleFileVisitor<Path> {

    private final Path root;
    private final List<Path> inside;
    private final Set<Path> written;

    Walk(Path root, List<Path> inside) {
      this.root = root;
      this.inside = inside;
      written = writtenAround(root);
    }

    @Override
    public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
      if (!folder.equals(root) && isPassedOver(folder)) {
        return FileVisitResult.SKIP_SUBTREE;
      }
      addWritten(folder, written);
      return FileVisitResult.CONTINUE;
    }

    private static boolean isPassedOver(Path folder) {
      String name = folder.getFileName().toString();
      return name.startsWith(".") || BUILT.contains(name) || isOfRuns(folder);
    }

    @Override
    public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
      if (attributes.isRegularFile()
          && !file.getFileName().toString().startsWith(".")
          && !written.contains(file)
          && TextFormat.of(file)
              .filter(it -> it != TextFormat.YAML || ProjectFolder.around(file).isPresent())
              .isPresent()) {
        inside.add(file);
      }
      return FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult visitFileFailed(Path file, IOException e) {
      found.add(FileRules.unreadable("The file or folder", file, e));
      return FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult postVisitDirectory(Path folder, IOException e) {
      return e == null ? FileVisitResult.CONTINUE : visitFileFailed(folder, e);
    }
  }
}
