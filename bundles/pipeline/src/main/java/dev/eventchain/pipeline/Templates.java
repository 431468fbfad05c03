package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.TemplateModule;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import org.eclipse.emf.ecore.EPackage;

/** The templates of a project: its own, or a set that ships with the program. */
final class Templates {

  /** The set of projects that name none. */
  static final String DEFAULT = "ros2-python";

  private static final String MAIN = "main";

  /** The sets, and the folder of the output that each writes into. */
  private static final SortedMap<String, String> FOLDERS =
      new TreeMap<>(Map.of("ros2-python", "ros2", "cyclonedds-python", "cyclonedds"));

  /** The folder of what several sets share. */
  private static final String SHARED = "python";

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
  static Optional<Path> own(Project project) {
    String name = project.configuration().template();
    return name.endsWith(".mtl") ? Optional.of(project.folder().resolve(name)) : Optional.empty();
  }

  /** The folder of the output that a project's templates write into, one for each middleware. */
  static String folder(Project project) {
    return FOLDERS.getOrDefault(project.configuration().template(), "ros2");
  }

  /** Whether pip installs what is generated, else the tools of ROS 2. */
  static boolean installsWithPip(Project project) {
    return project.configuration().template().equals("cyclonedds-python");
  }

  /**
   * Compiles the project's templates.
   *
   * @throws DiagnosticException INPUT if they have errors
   */
  static TemplateModule compile(Project project, Collection<EPackage> packages) {
    Optional<Path> own = own(project);
    if (own.isPresent()) {
      return TemplateModule.compile(own.get(), shippedModules(DEFAULT), packages);
    }
    String set = project.configuration().template();
    return shipped(set, MAIN, packages);
  }

  /** The files of the project's own template, if it has one. */
  static List<Path> ownFiles(Project project) {
    return own(project)
        .map(main -> TemplateModule.files(main, shippedModules(DEFAULT)))
        .orElse(List.of());
  }

  /**
   * Compiles a template that ships with the program.
   *
   * @param module the main module's name in the set
   */
  static TemplateModule shipped(String set, String module, Collection<EPackage> packages) {
    SourceText main = shipped(set, module).orElseThrow();
    return TemplateModule.compile(main, shippedModules(set), packages);
  }

  /**
   * Finds modules that ship with the program, for one compilation: {@code ros2_python::node} is of
   * the set {@code ros2-python}, and what it imports without a qualifier is then of that set, too.
   *
   * @param first the set of names without a qualifier until another one was named
   */
  private static Function<String, Optional<SourceText>> shippedModules(String first) {
    AtomicReference<String> set = new AtomicReference<>(first);
    return name -> {
      int qualifier = name.lastIndexOf("::");
      String module = qualifier < 0 ? name : name.substring(qualifier + 2);
      if (qualifier < 0) {
        return shipped(set.get(), module).or(() -> shipped(SHARED, module));
      }
      String folder = name.substring(0, qualifier).replace('_', '-');
      if (FOLDERS.containsKey(folder)) {
        set.set(folder);
      }
      return shipped(folder, module);
    };
  }

  private static Optional<SourceText> shipped(String set, String module) {
    if (!(set + module).matches("[A-Za-z0-9_-]+")) {
      return Optional.empty();
    }
    String name = "templates/" + set + "/" + module + ".mtl";
    try (InputStream stream = Templates.class.getResourceAsStream("/" + name)) {
      return stream == null
          ? Optional.empty()
          : Optional.of(
              SourceText.of(name, new String(stream.readAllBytes(), StandardCharsets.UTF_8)));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
