package dev.eventchain.lsp.check;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.project.ProjectFolder;
import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/**
 * The files of a workspace that are checked: those in its folders, and those open from elsewhere.
 * Results of runs, hidden folders and those of build tools are left out.
 */
public final class WorkspaceFiles {

  /** The most files that are looked at; a home folder that is opened by mistake has more. */
  private static final int MOST_FILES = 200_000;

  private static final String PROJECT = "eventchain.yaml";

  private static final Set<String> BUILT = Set.of("node_modules", "target", "__pycache__");

  private final Set<Path> projects = new TreeSet<>();
  private final Set<Path> files = new TreeSet<>();
  private int seen;

  private WorkspaceFiles() {}

  /** Looks for the files of folders, and adds open ones. */
  public static WorkspaceFiles of(List<Path> folders, Collection<Path> open) {
    WorkspaceFiles all = new WorkspaceFiles();
    folders.forEach(all::walk);
    for (Path file : open) {
      all.files.add(file);
      ProjectFolder.around(file).ifPresent(project -> all.projects.add(project.folder()));
    }
    return all;
  }

  private void walk(Path folder) {
    try {
      Path real = folder.toRealPath(); // A walk does not follow its start.
      Files.walkFileTree(real, new Collector(folder, real));
    } catch (IOException e) {
      // What can be read of the folder is checked; open files are, anyway.
      return;
    }
  }

  private final class Collector extends SimpleFileVisitor<Path> {

    private final Path named;
    private final Path root;

    Collector(Path named, Path root) {
      this.named = named;
      this.root = root;
    }

    /** Returns a path below the folder as the editor names it. */
    private Path named(Path path) {
      return named.resolve(root.relativize(path));
    }

    @Override
    public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
      boolean skipped = !folder.equals(root) && (isPassedOver(folder) || isOutput(folder));
      return skipped ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
      if (file.getFileName().toString().equals(PROJECT)) {
        projects.add(named(file).getParent());
      } else if (attributes.isRegularFile() && isKnown(file)) {
        files.add(named(file));
      }
      return ++seen < MOST_FILES ? FileVisitResult.CONTINUE : FileVisitResult.TERMINATE;
    }

    @Override
    public FileVisitResult visitFileFailed(Path file, IOException e) {
      return FileVisitResult.CONTINUE; // such as a folder without permission
    }
  }

  /** Returns whether a folder is hidden, or a build tool's. */
  public static boolean isPassedOver(Path folder) {
    String name = String.valueOf(folder.getFileName());
    return name.startsWith(".") || BUILT.contains(name);
  }

  /**
   * Returns whether a file, which may be gone, is left out in each of the folders that it is in;
   * one that is in none of them is not.
   */
  static boolean isPassedOver(Path file, List<Path> folders) {
    List<Path> around = folders.stream().filter(file::startsWith).toList();
    return !around.isEmpty() && around.stream().allMatch(each -> isPassedOverIn(each, file));
  }

  private static boolean isPassedOverIn(Path folder, Path file) {
    Path inside = file;
    while (!inside.equals(folder)) {
      if (isPassedOver(inside) || isOutput(inside)) {
        return true;
      }
      inside = inside.getParent();
    }
    return false;
  }

  private static boolean isOutput(Path folder) {
    return folder.endsWith("out") && Files.isRegularFile(folder.resolveSibling(PROJECT));
  }

  /** Returns whether a file may be a unit, or one that units of other files look for. */
  static boolean isKnown(Path file) {
    return switch (extension(file)) {
      case "mtl", "ocl", "ecore", "xmi", "eventchain" -> true;
      default -> false;
    };
  }

  static String extension(Path file) {
    String name = file.getFileName().toString();
    return name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
  }

  /** Returns the files with an ending, in the order of their paths. */
  public List<Path> with(String extension) {
    return files.stream().filter(file -> extension(file).equals(extension)).toList();
  }

  /** Returns all files that are checked one by one, in the order of their paths. */
  public List<Path> all() {
    return List.copyOf(files);
  }

  /** Returns the folders of projects. */
  public List<Path> projects() {
    return List.copyOf(projects);
  }

  /**
   * Returns the units of these files.
   *
   * @param named metamodels that the settings name, which count for all files
   */
  List<CheckUnit> units(List<Path> named, Duration timeLimit) {
    List<CheckUnit> units = new ArrayList<>();
    projects.forEach(folder -> units.add(new ProjectUnit(folder, timeLimit)));
    for (Path file : files) {
      unit(file, named, timeLimit).ifPresent(units::add);
    }
    return units;
  }

  private Optional<CheckUnit> unit(Path file, List<Path> named, Duration timeLimit) {
    List<Path> metamodels = metamodels(file, named);
    return switch (extension(file)) {
      case "mtl" -> Optional.of(new TemplateUnit(file, metamodels));
      case "ecore" -> Optional.of(new MetamodelUnit(file, beside(file, "ecore")));
      case "ocl" ->
          isPartOfProject(file) ? Optional.empty() : Optional.of(new RulesUnit(file, metamodels));
      case "xmi", "eventchain" ->
          isPartOfProject(file)
              ? Optional.empty()
              : Optional.of(new ModelUnit(file, metamodels, beside(file, "ocl"), timeLimit));
      default -> Optional.empty();
    };
  }

  /** Returns whether a file is the model, or a document of rules, that its project is about. */
  private static boolean isPartOfProject(Path file) {
    return ProjectFolder.around(file).stream()
        .flatMap(WorkspaceFiles::parts)
        .anyMatch(each -> each.toAbsolutePath().normalize().equals(file));
  }

  private static Stream<Path> parts(ProjectFolder project) {
    Path output = project.defaultOutput();
    return Stream.concat(project.model(output).stream(), rules(project, output).stream());
  }

  /** Returns a project's documents of rules; if one cannot be read, without their imports. */
  private static List<Path> rules(ProjectFolder project, Path output) {
    try {
      return project.constraintFiles(output);
    } catch (DiagnosticException e) {
      // The check of the project says why.
      return List.of(
          project.folder().resolve("constraints.ocl"), output.resolve(ProjectFolder.GENERATED));
    }
  }

  private List<Path> beside(Path file, String extension) {
    return with(extension).stream()
        .filter(each -> Objects.equals(each.getParent(), file.getParent()))
        .toList();
  }

  /**
   * Returns the metamodels that a file may name: those of the settings, and those in the nearest
   * folder around it that has any, or that has a folder with some.
   */
  public List<Path> metamodels(Path file, List<Path> named) {
    Set<Path> found = new LinkedHashSet<>(named);
    List<Path> all = with("ecore");
    for (Path around = file.getParent(); around != null; around = around.getParent()) {
      Path folder = around;
      List<Path> inside =
          all.stream()
              .filter(each -> each.startsWith(folder))
              .filter(each -> folder.relativize(each).getNameCount() <= 2)
              .sorted(Comparator.<Path>comparingInt(Path::getNameCount).thenComparing(each -> each))
              .toList();
      if (!inside.isEmpty()) {
        found.addAll(inside);
        break;
      }
    }
    return List.copyOf(found);
  }
}
