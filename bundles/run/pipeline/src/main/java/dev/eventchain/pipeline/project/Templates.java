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
import org.eclipse.emf.ecore.EPackage;

/** The templates of a project: its own, or a set that ships with the program. */
public final class Templates {

  /** The set of projects that name none. */
  static final String DEFAULT = ShippedTemplates.DEFAULT;

  private static final String MAIN = "main";

  /** The sets, and the folder of the output that each writes into. */
  private static final SortedMap<String, String> FOLDERS =
      new TreeMap<>(Map.of(DEFAULT, "ros2", "cyclonedds-python", "cyclonedds"));

  private Templates() {}

  /** The names of the sets, in order. */
  static Set<String> sets() {
    return FOLDERS.keySet();
  }

  /**
   * Whether there is such a template.
   *
   * @param folder that of the project
   */
  static boolean exists(Path folder, String template) {
    return template.endsWith(".mtl")
        ? Files.isRegularFile(folder.resolve(template))
        : FOLDERS.containsKey(template);
  }

  /** The project's own template file, if its configuration names one. */
  public static Optional<Path> own(Project project) {
    String name = project.configuration().template();
    return name.endsWith(".mtl") ? Optional.of(project.folder().resolve(name)) : Optional.empty();
  }

  /** The folder of the output that a project's templates write into, one for each middleware. */
  public static String folder(Project project) {
    return FOLDERS.getOrDefault(project.configuration().template(), "ros2");
  }

  /** Whether pip installs what is generated, else the tools of ROS 2. */
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

  /** The files of the project's own template, if it has one. */
  public static List<Path> ownFiles(Project project) {
    return own(project)
        .map(main -> TemplateModule.files(main, ShippedTemplates.modules(DEFAULT)))
        .orElse(List.of());
  }

  /**
   * Compiles a template that ships with the program.
   *
   * @param module the main module's name in the set
   */
  public static TemplateModule shipped(String set, String module, Collection<EPackage> packages) {
    SourceText main = ShippedTemplates.module(set, module).orElseThrow();
    return TemplateModule.compile(main, ShippedTemplates.modules(set), packages);
  }
}
