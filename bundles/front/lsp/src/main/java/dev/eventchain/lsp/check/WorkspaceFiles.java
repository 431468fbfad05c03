package dev.eventchain.lsp.check;

import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
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
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The files of a workspace that are checked: those in its folders, and those open from elsewhere.
 * Results of runs, hidden folders and those of build tools are left out.
 */
public final class WorkspaceFiles {

  /** The most files that are looked at; a home folder that is opened by mistake has more. */
  private static final int MOST_FILES = 200_000;

  private static final Set<String> BUILT = Set.of("node_modules", "target", "__pycache__");

  /** The nearest metamodels come first. */
  private static final Comparator<Path> NEAREST =
      Comparator.comparingInt(Path::getNameCount).thenComparing(Comparator.naturalOrder());

  private final List<Path> projects;
  private final List<Path> files;
  private final Map<String, List<Path>> byExtension;

  /** The files of each folder by their endings. */
  private final Map<Path, Map<String, List<Path>>> byFolder = new HashMap<>();

  /** The metamodels in each folder, and in folders directly in it. */
  private final Map<Path, List<Path>> metamodels = new HashMap<>();

  private WorkspaceFiles(Found found) {
    projects = List.copyOf(found.projects);
    files = List.copyOf(found.files);
    byExtension = files.stream().collect(Collectors.groupingBy(WorkspaceFiles::extension));
    for (Path file : files) {
      byFolder
          .computeIfAbsent(file.getParent(), folder -> new HashMap<>())
          .computeIfAbsent(extension(file), extension -> new ArrayList<>())
          .add(file);
    }
    for (Path ecore : with("ecore")) {
      for (Path folder : above(ecore)) {
        metamodels.computeIfAbsent(folder, key -> new ArrayList<>()).add(ecore);
      }
    }
    metamodels.values().forEach(each -> each.sort(NEAREST));
  }

  /** Returns the folder of a file, and the one around it. */
  private static List<Path> above(Path file) {
    return Stream.iterate(file.getParent(), Objects::nonNull, Path::getParent).limit(2).toList();
  }

  /** Looks for the files of folders, and adds open ones. */
  public static WorkspaceFiles of(List<Path> folders, Collection<Path> open) {
    Found found = new Found();
    folders.forEach(found::walk);
    for (Path file : open) {
      found.files.add(file);
      ProjectFolder.around(file).ifPresent(project -> found.projects.add(project.folder()));
    }
    return new WorkspaceFiles(found);
  }

  private static final class Found {

    private final Set<Path> projects = new TreeSet<>();
    private final Set<Path> files = new TreeSet<>();
    private int seen;

    private void walk(Path folder) {
      try {
        Path real = folder.toRealPath(); // A walk does not follow its start.
        Files.walkFileTree(real, new Collector(this, folder, real));
      } catch (IOException e) {
        // What can be read of the folder is checked; open files are, anyway.
        return;
      }
    }
  }

  private static final class Collector extends SimpleFileVisitor<Path> {

    private final Found found;
    private final Path named;
    private final Path root;

    Collector(Found found, Path named, Path root) {
      this.found = found;
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
      if (file.getFileName().toString().equals(ProjectLayout.CONFIGURATION)) {
        found.projects.add(named(file).getParent());
      } else if (attributes.isRegularFile() && isKnown(file)) {
        found.files.add(named(file));
      }
      return ++found.seen < MOST_FILES ? FileVisitResult.CONTINUE : FileVisitResult.TERMINATE;
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
    return folder.endsWith(ProjectLayout.OUTPUT)
        && Files.isRegularFile(folder.resolveSibling(ProjectLayout.CONFIGURATION));
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
    return byExtension.getOrDefault(extension, List.of());
  }

  /** Returns all files that are checked one by one, in the order of their paths. */
  public List<Path> all() {
    return files;
  }

  /** Returns the folders of projects. */
  public List<Path> projects() {
    return projects;
  }

  /**
   * Returns the units of these files.
   *
   * @param named metamodels that the settings name, which count for all files
   */
  List<CheckUnit> units(List<Path> named, Duration timeLimit) {
    List<CheckUnit> units = new ArrayList<>();
    projects.forEach(folder -> units.add(new ProjectUnit(folder, timeLimit)));
    projects.forEach(folder -> units.add(new CampaignUnit(folder)));
    ProjectParts parts = new ProjectParts();
    for (Path file : files) {
      unit(file, named, parts, timeLimit).ifPresent(units::add);
    }
    return units;
  }

  private Optional<CheckUnit> unit(
      Path file, List<Path> named, ProjectParts parts, Duration timeLimit) {
    List<Path> metamodels = metamodels(file, named);
    return switch (extension(file)) {
      case "mtl" -> Optional.of(new TemplateUnit(file, metamodels));
      case "ecore" -> Optional.of(new MetamodelUnit(file, beside(file, "ecore")));
      case "ocl" ->
          parts.contains(file) ? Optional.empty() : Optional.of(new RulesUnit(file, metamodels));
      case "xmi", "eventchain" ->
          parts.contains(file)
              ? Optional.empty()
              : Optional.of(new ModelUnit(file, metamodels, beside(file, "ocl"), timeLimit));
      default -> Optional.empty();
    };
  }

  private List<Path> beside(Path file, String extension) {
    return byFolder.getOrDefault(file.getParent(), Map.of()).getOrDefault(extension, List.of());
  }

  /**
   * Returns the metamodels that a file may name: those of the settings, and those in the nearest
   * folder around it that has any, or that has a folder with some.
   */
  public List<Path> metamodels(Path file, List<Path> named) {
    Set<Path> found = new LinkedHashSet<>(named);
    Stream.iterate(file.getParent(), Objects::nonNull, Path::getParent)
        .filter(metamodels::containsKey)
        .findFirst()
        .ifPresent(folder -> found.addAll(metamodels.get(folder)));
    return List.copyOf(found);
  }
}
