package dev.eventchain.pipeline.mutation;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.pipeline.generate.HostedNodes;
import dev.eventchain.pipeline.stage.ComponentSources;
import dev.eventchain.pipeline.stage.NodeModules;
import dev.eventchain.project.SoftwareBase;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;

/** Modules of a project that its components and nodes as they are import, each of them once. */
final class ImportedModules {

  private final SortedMap<Path, SortedMap<String, SoftwareBase.Component>> users = new TreeMap<>();
  private final SortedMap<Path, String> copies = new TreeMap<>();
  private final SortedSet<Path> importers = new TreeSet<>();
  private final Collection<SoftwareBase.Component> components;

  /**
   * Finds the modules, without files of components.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if a file cannot be read
   */
  ImportedModules(Collection<SoftwareBase.Component> components) {
    this.components = List.copyOf(components);
    for (SoftwareBase.Component component : components) {
      importers.add(component.file());
      if (component.node().isPresent()) {
        addNode(component, component.node().get().root());
      } else {
        ComponentSources.modules(List.of(component)).forEach(file -> add(file, component));
      }
    }
  }

  /** Adds the modules of a node; those of two nodes that have the same copy are one. */
  private void addNode(SoftwareBase.Component component, Path root) {
    for (Path file : NodeModules.withNode(component)) {
      if (file.startsWith(root)) {
        String copy = HostedNodes.copy(root, file);
        Path known =
            copies.entrySet().stream()
                .filter(each -> each.getValue().equals(copy))
                .map(Map.Entry::getKey)
                .findFirst()
                .orElse(file);
        if (add(known, component)) {
          copies.put(known, copy);
        }
      }
    }
  }

  private boolean add(Path file, SoftwareBase.Component component) {
    importers.add(file);
    if (components.stream().anyMatch(each -> each.file().equals(file))) {
      return false;
    }
    users.computeIfAbsent(file, it -> new TreeMap<>()).put(component.name(), component);
    return true;
  }

  /** Returns the files. */
  SortedSet<Path> files() {
    return Collections.unmodifiableSortedSet(new TreeSet<>(users.keySet()));
  }

  /** Returns the components and nodes that import a module, in the order of the chain. */
  List<SoftwareBase.Component> users(Path file) {
    return components.stream()
        .filter(each -> users.getOrDefault(file, new TreeMap<>()).containsKey(each.name()))
        .toList();
  }

  /** Returns where the copy of a module is that hosted nodes import, in the generated package. */
  Optional<String> copy(Path file) {
    return Optional.ofNullable(copies.get(file));
  }

  /** Returns the texts of the files that may import a module. */
  List<String> importers(Path file) {
    List<String> texts = new ArrayList<>();
    for (Path importer : importers) {
      if (!importer.equals(file)) {
        texts.add(SourceText.read(importer).text());
      }
    }
    return texts;
  }
}
