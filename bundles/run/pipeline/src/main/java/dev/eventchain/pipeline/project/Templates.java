package dev.eventchain.pipeline.project;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.templates.ShippedTemplates;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import org.eclipse.emf.ecore.EPackage;

/** The templates of a project: its own, or a set that ships with the program. */
public final class Templates {

  /** Template set of projects that name none. */
  static final String DEFAULT = ShippedTemplates.DEFAULT;

  private static final String MAIN = "main";

  /** Template sets, and the output folder of each. */
  private static final SortedMap<String, String> FOLDERS =
      new TreeMap<>(Map.of(DEFAULT, "ros2", "cyclonedds-python", "cyclonedds"));

  /**
   * Cache: shipped templates never change, and compiling them takes longer than generating with
   * them.
   */
  private static final Map<Shipped, TemplateModule> COMPILED = new ConcurrentHashMap<>();

  private record Shipped(String set, String module, List<EPackage> packages) {}

  private Templates() {}

  /** Returns the names of the sets, in order. */
  static Set<String> sets() {
    return FOLDERS.keySet();
  }

  /**
   * Returns whether a template exists.
   *
   * @param folder the folder of the project
   */
  static boolean exists(Path folder, String template) {
    return template.endsWith(".mtl")
        ? Files.isRegularFile(folder.resolve(template))
        : FOLDERS.containsKey(template);
  }

  /** Returns the project's own template file, if its configuration names one. */
  public static Optional<Path> own(Project project) {
    String name = project.configuration().template();
    return name.endsWith(".mtl") ? Optional.of(project.folder().resolve(name)) : Optional.empty();
  }

  /** Returns the output folder of a project's templates, one for each middleware. */
  public static String folder(Project project) {
    return FOLDERS.getOrDefault(project.configuration().template(), "ros2");
  }

  /** Returns whether pip installs the generated package, instead of the ROS 2 tools. */
  public static boolean installsWithPip(Project project) {
    return project.configuration().template().equals("cyclonedds-python");
  }

  /**
   * Compiles the project's templates.
   *
   * @throws DiagnosticException INPUT if they have errors
   */
  public static TemplateModule compile(Project project, Collection<EPackage> packages) {
    Optional<Path> own = own(project);
    if (own.isPresent()) {
      return TemplateModule.compile(own.get(), ShippedTemplates.modules(DEFAULT), packages);
    }
    String set = project.configuration().template();
    return shipped(set, MAIN, packages);
  }

  /** Returns the files of the project's own template, if it has one. */
  public static List<Path> ownFiles(Project project) {
    return own(project)
        .map(main -> TemplateModule.files(main, ShippedTemplates.modules(DEFAULT)))
        .orElse(List.of());
  }

  /**
   * Returns a shipped template, which is compiled once for each metamodel.
   *
   * @param module the main module's name in the set
   */
  public static TemplateModule shipped(String set, String module, Collection<EPackage> packages) {
    return COMPILED.computeIfAbsent(
        new Shipped(set, module, List.copyOf(packages)), Templates::compile);
  }

  private static TemplateModule compile(Shipped template) {
    SourceText main = ShippedTemplates.module(template.set(), template.module()).orElseThrow();
    return TemplateModule.compile(
        main, ShippedTemplates.modules(template.set()), template.packages());
  }
}
