package dev.eventchain.pipeline.stage;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.sandbox.ComponentRules;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * Modules of a project that its existing components import by name, directly or through each other:
 * Python files beside them.
 */
public final class HelperModules {

  private final Map<String, Path> components;
  private final SortedMap<String, Path> files = new TreeMap<>();
  private final List<Diagnostic> found = new ArrayList<>();

  private HelperModules(Map<String, Path> components) {
    this.components = components;
  }

  /**
   * Finds the modules of existing components.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if a file cannot be read
   */
  public static HelperModules of(Collection<SoftwareBase.Component> components) {
    HelperModules modules =
        new HelperModules(
            components.stream()
                .collect(
                    Collectors.toMap(SoftwareBase.Component::name, SoftwareBase.Component::file)));
    Deque<Path> pending = new ArrayDeque<>();
    components.forEach(component -> pending.add(component.file()));
    while (!pending.isEmpty()) {
      pending.addAll(modules.importedBy(pending.remove()));
    }
    return modules;
  }

  /** Returns the files by the names of the modules. */
  public SortedMap<String, Path> files() {
    return Collections.unmodifiableSortedMap(files);
  }

  /** Returns the findings about imports that fail where a component runs. */
  public List<Diagnostic> diagnostics() {
    return List.copyOf(found);
  }

  /** Adds the modules that a file imports; returns those that are new. */
  private List<Path> importedBy(Path importer) {
    SourceText text = SourceText.read(importer);
    List<Path> added = new ArrayList<>();
    PythonImports.modules(text.text())
        .forEach(
            (module, offset) -> {
              Path file = importer.resolveSibling(module + ".py");
              if (Files.isRegularFile(file)) {
                if (isUsable(module, file, text, offset) && !files.containsKey(module)) {
                  files.put(module, file);
                  added.add(file);
                }
              } else if (isFolder(importer.resolveSibling(module), module)) {
                String message = "'" + module + "' is a folder, of which no file would be copied.";
                found.add(finding(message, "Write one file, " + module + ".py.", text, offset));
              }
            });
    return added;
  }

  private static boolean isFolder(Path folder, String module) {
    return Files.isRegularFile(folder.resolve("__init__.py")) && !PythonImports.isStandard(module);
  }

  /** Returns whether the import finds the file beside the importer wherever it runs. */
  private boolean isUsable(String module, Path file, SourceText text, int offset) {
    Path other = files.getOrDefault(module, components.getOrDefault(module, file));
    if (PythonImports.isStandard(module)) {
      if (!components.containsValue(file)) { // a component that happens to have that name
        String message = "'" + module + "' is a module of Python itself, which hides the file.";
        found.add(finding(message, "Rename " + module + ".py.", text, offset));
      }
      return false;
    }
    if (!other.equals(file)) {
      String message = "There are two files for '" + module + "': " + file + " and " + other + ".";
      found.add(finding(message, "Rename one of them.", text, offset));
      return false;
    }
    return true;
  }

  private static Diagnostic finding(String message, String hint, SourceText text, int offset) {
    return Diagnostic.of(ComponentRules.IMPORT_HELPER, message, text.at(offset)).withHint(hint);
  }
}
